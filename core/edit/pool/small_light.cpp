#include "core/edit/pool/small_light.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

// How much of the light is there, from its ratio to the others over that ratio where the light is: from none
// (bounced light only) to all.
constexpr double kNoLight = 0.04;
constexpr double kAllLight = 0.25;
// The same of its level, where a cone is looked for: where no other light reaches either, bounced light alone
// makes any ratio. From the darkest surfaces that are lit to the brightest that only bounced light reaches.
constexpr double kDarkest = 0.02;
constexpr double kBounced = 0.08;
constexpr double kFaintOthers = 0.02;  // of their mean: below, a ratio to them says nothing
constexpr double kMostRatio = 400;

// The median of the values, each counted by its weight.
double weightedMedian(const cv::Mat& values, const cv::Mat& weights) {
  const auto* v = values.ptr<float>();
  const auto* w = weights.ptr<float>();
  std::vector<size_t> order(values.total());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return v[a] < v[b]; });
  const double half = cv::sum(weights)[0] / 2;
  double below = 0;
  for (const size_t p : order) {
    below += w[p];
    if (below >= half) return v[p];
  }
  return 0;
}

// A smooth step up, from none to all of what the light is where it shines (`own`).
cv::Mat stepOf(const cv::Mat& light, const cv::Mat& own, double none, double all) {
  const double full = weightedMedian(light, own);
  cv::Mat seen = (light / std::max(full, 1e-12) - none) / (all - none);
  seen = cv::min(cv::max(seen, 0), 1);
  return seen.mul(seen).mul(3 - 2 * seen);
}

}  // namespace

cv::Mat shrunkPlane(const Image& image, int channel, const cv::Size& size) {
  const cv::Mat plane(image.height(), image.width(), CV_32F, const_cast<float*>(image.plane(channel)));
  cv::Mat small;
  cv::resize(plane, small, size, 0, 0, cv::INTER_AREA);
  return small;
}

cv::Mat SmallLight::seen() const {
  const double faint = kFaintOthers * cv::mean(othersGrey)[0];
  const cv::Mat ratio = alone() ? ownGrey : cv::Mat(ownGrey / cv::max(othersGrey, faint));
  return stepOf(ratio, ownGrey, kNoLight, kAllLight);
}

cv::Mat SmallLight::lit() const {
  return cv::min(seen(), stepOf(ownGrey, ownGrey, kDarkest, kBounced));
}

cv::Mat SmallLight::logRatio(const cv::Mat& ofOwn, const cv::Mat& ofOthers) const {
  const cv::Mat ratio = alone() ? ofOwn : cv::Mat((ofOwn + 1e-6) / (ofOthers + 1e-6));
  cv::Mat logarithm;
  cv::log(cv::min(cv::max(ratio, 1 / kMostRatio), kMostRatio), logarithm);
  return logarithm;
}

SmallLight smallLight(const SolvedSet& set, size_t light, int width) {
  width = std::min(width, set.width());
  const cv::Size size(
      width, std::max(1, static_cast<int>(std::lround(double{1} * set.height() * width / set.width()))));
  const size_t lights = set.contributions.size();
  std::vector<cv::Mat> planes(3 * lights);
  parallelEach(static_cast<int>(planes.size()), [&](int k) {
    planes[static_cast<size_t>(k)] = shrunkPlane(set.contributions[static_cast<size_t>(k) / 3], k % 3, size);
  });
  SmallLight small;
  for (size_t c = 0; c < 3; ++c) {
    small.own[c] = planes[3 * light + c];
    small.others[c] = cv::Mat::zeros(size, CV_32F);
    for (size_t i = 0; i < lights; ++i)
      if (i != light) small.others[c] += planes[3 * i + c];
  }
  small.ownGrey = (small.own[0] + small.own[1] + small.own[2]) / 3;
  small.othersGrey = (small.others[0] + small.others[1] + small.others[2]) / 3;
  return small;
}

}  // namespace swaplight
