#include "core/chart/chart_finder.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/mcc.hpp>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/quantile.h"
#include "core/chart/chart_reading.h"
#include "core/chart/chart_refinement.h"

namespace swaplight {
namespace {

constexpr int kMostAcross = 1600;  // pixels of the larger side in which a chart is looked for
constexpr double kLeastLikeness = .8;
constexpr double kGamma = 1 / 2.2;
constexpr float kModelMargin = .1F;  // patches by which OpenCV's box of the chart is larger, all around

struct Likely {
  ChartCorners corners;
  double likeness = 0;
};

Likely likeliest(const Image& picture, float clipLevel, const ChartCorners& corners) {
  Likely best;
  for (const ChartCorners& one : arrangementsOf(corners))
    if (const double likeness = chartLikeness(readChart(picture, clipLevel, one)); likeness >= best.likeness)
      best = {one, likeness};
  return best;
}

/// Linear light, B G R, at the size in which a chart is looked for; what is no number is black.
cv::Mat smallCopy(const Image& picture, double scale) {
  std::vector<cv::Mat> planes;
  for (const int c : {2, 1, 0}) {
    cv::Mat plane = cv::Mat(picture.height(), picture.width(), CV_32F,
                            const_cast<float*>(picture.plane(c)))  // NOLINT: it is copied
                        .clone();
    cv::patchNaNs(plane, 0);
    cv::min(plane, 1e4F, plane);
    if (scale < 1) cv::resize(plane, plane, {}, scale, scale, cv::INTER_AREA);
    planes.push_back(plane);
  }
  cv::Mat all;
  cv::merge(planes, all);
  return all;
}

float levelOf(const cv::Mat& plane, double q) {
  std::vector<float> values(plane.begin<float>(), plane.end<float>());
  return std::max(quantile(std::span(values), q), 1e-6F);
}

/// Eight bits of a display; `q` of every channel's pixels are below white.
cv::Mat coded(const cv::Mat& linear, double q, bool grey) {
  std::vector<cv::Mat> planes;
  cv::split(linear, planes);
  for (cv::Mat& plane : planes) {
    plane = plane / levelOf(plane, q);
    cv::max(plane, 0, plane);
    cv::min(plane, 1, plane);
    cv::pow(plane, kGamma, plane);
  }
  if (grey) {
    cv::Mat mean = (planes[0] + planes[1] + planes[2]) / 3;
    planes = {mean, mean, mean};
  }
  cv::Mat all, codes;
  cv::merge(planes, all);
  all.convertTo(codes, CV_8U, 255);
  return codes;
}

/// OpenCV fills its tables of Lab at their first use, without a lock, and its detector uses them in several
/// threads at once: they are filled here, in one.
void fillTablesOfLab() {
  static const bool filled = [] {
    cv::Mat one(1, 1, CV_32FC3, cv::Scalar::all(.5));
    cv::cvtColor(one, one, cv::COLOR_BGR2Lab);
    return true;
  }();
  static_cast<void>(filled);
}

/// The box of OpenCV's best chart, brought to the patches' outer corners and the picture's own size.
std::optional<ChartCorners> detected(const cv::Mat& codes, double scale) {
  const cv::Ptr<cv::mcc::CCheckerDetector> detector = cv::mcc::CCheckerDetector::create();
  fillTablesOfLab();
  std::vector<cv::Point2f> box;
  try {
    if (!detector->process(codes, cv::mcc::MCC24)) return std::nullopt;
    box = detector->getBestColorChecker()->getBox();
  } catch (const cv::Exception&) {  // of pictures in which it finds too little to fit anything to
    return std::nullopt;
  }
  if (box.size() != 4) return std::nullopt;
  ChartCorners outer;
  for (size_t j = 0; j < 4; ++j) outer[j] = {double(box[j].x), double(box[j].y)};
  try {
    const ChartPerspective perspective(outer);
    const double x = kModelMargin / (kChartWidth + 2 * kModelMargin);
    const double y = kModelMargin / (kChartHeight + 2 * kModelMargin);
    ChartCorners corners{perspective.inPicture({x, y}), perspective.inPicture({1 - x, y}),
                         perspective.inPicture({1 - x, 1 - y}), perspective.inPicture({x, 1 - y})};
    for (PicturePlace& corner : corners)
      corner = {(corner.x + .5) / scale - .5, (corner.y + .5) / scale - .5};
    return corners;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<ChartCorners> findChart(const Image& picture, float clipLevel, const Progress& progress) {
  const double scale = std::min(1.0, double(kMostAcross) / std::max(picture.width(), picture.height()));
  const cv::Mat linear = smallCopy(picture, scale);
  const struct {
    double white;
    bool grey;
  } ways[] = {{.99, false}, {.9, false}, {.99, true}, {.9, true}};
  float done = 0;
  for (const auto& way : ways) {
    progress.update(done, "looking for the chart");
    done += 1.0F / std::size(ways);
    const auto corners = detected(coded(linear, way.white, way.grey), scale);
    if (!corners) continue;
    try {
      const Likely likely = likeliest(picture, clipLevel, *corners);
      if (likely.likeness >= kLeastLikeness) return refinedCorners(picture, likely.corners);
    } catch (const InputError&) {
      continue;  // outside of the picture, or tiny: no chart that can be read
    }
  }
  return std::nullopt;
}

ChartCorners orientedCorners(const Image& picture, float clipLevel, const ChartCorners& corners) {
  const Likely likely = likeliest(picture, clipLevel, corners);
  if (likely.likeness < kLeastLikeness)
    throw InputError(
        "what lies between the four corners does not look like a Macbeth chart ({:.0f} % of it does): tell "
        "the outer corners of its four corner patches",
        100 * likely.likeness);
  return refinedCorners(picture, likely.corners);
}

}  // namespace swaplight
