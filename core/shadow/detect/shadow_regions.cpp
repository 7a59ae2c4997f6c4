#include "core/shadow/detect/shadow_regions.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc/edge_filter.hpp>

#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

enum Marker { kShadowMarker = 1, kLitMarker = 2 };

// The shading as 8 bits: what OpenCV's watershed takes.
cv::Mat eightBits(const cv::Mat& shading, const cv::Mat& known) {
  double low = 0;
  double high = 0;
  cv::minMaxLoc(shading, &low, &high, nullptr, nullptr, known);
  cv::Mat grey;
  shading.convertTo(grey, CV_8U, 255 / std::max(high - low, 1e-6), -low * 255 / std::max(high - low, 1e-6));
  cv::Mat color;
  cv::merge(std::vector<cv::Mat>(3, grey), color);
  return color;
}

// A mask, larger, but for what is beside its border.
cv::Mat insideOf(const cv::Mat& mask, cv::Size full) {
  cv::Mat inside;
  cv::erode(mask, inside, {}, {-1, -1}, 1, cv::BORDER_CONSTANT, cv::Scalar(255));
  cv::resize(inside, inside, full, 0, 0, cv::INTER_NEAREST);
  return inside;
}

// Sets the pixels of small connected parts of `mask` (8-bit) to 0, where none of them is marked.
void removeSmallParts(cv::Mat& mask, int smallest, std::span<const cv::Point> marked) {
  cv::Mat parts, statistics, centers;
  const int count = cv::connectedComponentsWithStats(mask, parts, statistics, centers, 8, CV_32S);
  std::vector<bool> small(static_cast<size_t>(count));
  for (int part = 1; part < count; ++part)
    small[static_cast<size_t>(part)] = statistics.at<int>(part, cv::CC_STAT_AREA) < smallest;
  for (const cv::Point pixel : marked) small[static_cast<size_t>(parts.at<int>(pixel))] = false;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x)
      if (small[static_cast<size_t>(parts.at<int>(y, x))]) mask.at<uchar>(y, x) = 0;
}

}  // namespace

int smallestShadow(const ShadowOptions& options, const cv::Mat& known) {
  const float share = options.smallestShare * static_cast<float>(known.total());
  return std::max(4, static_cast<int>(std::lround(share)));
}

void removeSmallShadows(cv::Mat& visibility, int smallest, const ShadowRegionsTuning& tuning,
                        std::span<const cv::Point> marked) {
  cv::Mat shadow = visibility < tuning.lit;
  cv::Mat large = shadow.clone();
  removeSmallParts(large, smallest, marked);
  visibility.setTo(1, shadow & ~large);
  cv::Mat gaps = ~(visibility < tuning.umbra);
  if (cv::countNonZero(gaps) == static_cast<int>(gaps.total())) return;  // in no umbra
  cv::Mat largeGaps = gaps.clone();
  removeSmallParts(largeGaps, smallest, marked);
  visibility.setTo(0, gaps & ~largeGaps);
}

cv::Mat visibilityOf(const ShadowEvidence& light, const cv::Mat& shadow, const cv::Mat& known, int smallest,
                     const ShadowRegionsTuning& tuning, std::span<const cv::Point> marked) {
  const cv::Size full = light.level.size();
  cv::Mat cut;
  cv::resize(shadow, cut, full, 0, 0, cv::INTER_NEAREST);
  cv::Mat markers(full, CV_32S, cv::Scalar(0));
  markers.setTo(kShadowMarker, insideOf(shadow, full));
  markers.setTo(kLitMarker, insideOf(~shadow, full));
  cv::watershed(eightBits(light.shading, known), markers);
  cv::Mat lit(light.level.size(), CV_32F);
  for (int y = 0; y < lit.rows; ++y)
    for (int x = 0; x < lit.cols; ++x) {
      const int marker = markers.at<int>(y, x);  // -1 on the watershed and on the picture's rim
      const bool inShadow = marker == -1 ? cut.at<uchar>(y, x) != 0 : marker == kShadowMarker;
      lit.at<float>(y, x) = inShadow ? 0.f : 1.f;
    }

  // Soften.
  cv::Mat visibility;
  const int radius = std::max(1, static_cast<int>(std::lround(tuning.softening * referenceUnit(lit))));
  cv::ximgproc::guidedFilter(light.level * tuning.guideScale, lit, visibility, radius, tuning.guideEpsilon);
  cv::min(visibility, 1, visibility);
  cv::max(visibility, 0, visibility);
  removeSmallShadows(visibility, smallest, tuning, marked);
  return visibility;
}

cv::Mat toldPixels(const ShadowDivision& division, const cv::Mat& known) {
  return known & (grown(asFloat(division.untold), known.size()) < .5);
}

std::vector<ShadowLabel> labelShadows(const cv::Mat& visibility, const cv::Mat& known,
                                      const ShadowRegionsTuning& tuning) {
  std::vector<ShadowLabel> labels;
  labels.reserve(visibility.total());
  for (int y = 0; y < visibility.rows; ++y)
    for (int x = 0; x < visibility.cols; ++x) {
      const float v = visibility.at<float>(y, x);
      labels.push_back(!known.at<uchar>(y, x) ? ShadowLabel::Unknown
                       : v < tuning.umbra     ? ShadowLabel::Umbra
                       : v < tuning.lit       ? ShadowLabel::Penumbra
                                              : ShadowLabel::Lit);
    }
  return labels;
}

}  // namespace swaplight
