#include "core/edit/apply/shadow_silhouette.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/edit/pool/small_light.h"

namespace swaplight {
namespace {

constexpr int kLongest = 960;        // pixels: outlines are sought in a smaller picture
constexpr int kWindowsAcross = 240;  // a window reaches so much of the picture to each side
constexpr int kLeastReach = 3;       // pixels
constexpr int kAround = 4;           // windows: the edge around
// Squared correlation of the visibility with the logarithm of the other lights: half of the variance is where
// an outline may begin, .8 one. Of all of the edge around .3 and half.
constexpr float kAlike = 0.5F, kSame = 0.8F, kSomeAround = 0.3F, kMostAround = 0.5F;
constexpr float kLeastEdge = 0.05F;  // standard deviation in a window: of visibility, and of logarithms
constexpr float kDark = 0.02F;       // of the mean light: darker places are all alike

cv::Mat meanAround(const cv::Mat& x, int reach) {
  cv::Mat mean;
  cv::blur(x, mean, {2 * reach + 1, 2 * reach + 1}, {-1, -1}, cv::BORDER_REPLICATE);
  return mean;
}

/// What the other lights show in a channel.
cv::Mat otherLights(const SolvedSet& set, size_t light, int channel, cv::Size size) {
  cv::Mat sum = cv::Mat::zeros(size, CV_32F);
  for (size_t i = 0; i < set.contributions.size(); ++i)
    if (i != light) sum += shrunkPlane(set.contributions[i], channel, size);
  sum += std::max(kDark * cv::mean(sum)[0], 1e-20);
  cv::log(sum, sum);
  return sum;
}

/// 0 below `from`, 1 above `to`.
cv::Mat ramp(const cv::Mat& x, float from, float to) {
  cv::Mat y = (x - from) / (to - from);
  cv::max(y, 0, y);
  cv::min(y, 1, y);
  return y;
}

cv::Mat squared(const cv::Mat& x) {
  return x.mul(x);
}

cv::Mat asFloat(const cv::Mat& mask) {
  cv::Mat floats;
  mask.convertTo(floats, CV_32F, 1 / 255.);
  return floats;
}

}  // namespace

Image shadowSilhouettes(const Image& visibility, const SolvedSet& set, size_t light) {
  const int width = visibility.width(), height = visibility.height();
  const int shrink = (std::max(width, height) + kLongest - 1) / kLongest;
  const cv::Size size((width + shrink - 1) / shrink, (height + shrink - 1) / shrink);
  const int reach = std::max(kLeastReach, size.width / kWindowsAcross);
  const cv::Mat seen = shrunkPlane(visibility, 0, size);
  const cv::Mat meanSeen = meanAround(seen, reach);
  const cv::Mat edge = meanAround(squared(seen), reach) - squared(meanSeen);
  const cv::Mat isEdge = asFloat(edge > kLeastEdge * kLeastEdge);

  cv::Mat alike = cv::Mat::zeros(size, CV_32F);
  for (int c = 0; c < 3; ++c) {
    const cv::Mat others = otherLights(set, light, c, size);
    const cv::Mat mean = meanAround(others, reach);
    const cv::Mat varies = meanAround(squared(others), reach) - squared(mean);
    const cv::Mat together = meanAround(seen.mul(others), reach) - meanSeen.mul(mean);
    cv::Mat correlation = squared(together) / cv::max(edge.mul(varies), 1e-8);
    correlation = correlation.mul(asFloat(varies > kLeastEdge * kLeastEdge));
    cv::max(alike, correlation, alike);
  }
  const cv::Mat outline = ramp(alike, kAlike, kSame).mul(isEdge);
  const cv::Mat weight = isEdge.mul(edge);
  const cv::Mat share =
      meanAround(outline.mul(weight), kAround * reach) / cv::max(meanAround(weight, kAround * reach), 1e-7);

  Image found(ImageSpec{size.width, size.height, {"Y"}, "data"});
  cv::Mat pixels(size, CV_32F, found.plane(0));
  cv::multiply(outline, ramp(share, kSomeAround, kMostAround), pixels);
  return found;
}

}  // namespace swaplight
