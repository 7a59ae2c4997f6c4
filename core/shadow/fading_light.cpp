#include "core/shadow/fading_light.h"

#include <algorithm>
#include <opencv2/ximgproc/edge_filter.hpp>

#include "core/shadow/other_lights.h"
#include "core/shadow/poisson.h"
#include "core/shadow/shadow_pictures.h"

namespace swaplight {
namespace {

cv::Mat localMean(const cv::Mat& x, const cv::Mat& where, const cv::Mat& guide, double radius) {
  cv::Mat sum, weight;
  cv::ximgproc::dtFilter(guide, x.mul(where), sum, radius, kGuideReach);
  cv::ximgproc::dtFilter(guide, where, weight, radius, kGuideReach);
  return sum / cv::max(weight, 1e-6);
}

}  // namespace

FadingLight fadingLight(const cv::Mat& ratio, const cv::Mat& fixed, const cv::Mat& guide) {
  const cv::Mat where = asFloat(fixed);
  const double near = std::max(2., 3. * referenceUnit(ratio));
  FadingLight light;
  light.around = cv::max(localMean(ratio, where, guide, 5 * near), 1e-6);
  light.cast = clampedToOne((localMean(ratio, where, guide, near) / light.around - .65) / .2);
  return light;
}

cv::Mat castBeyond(const FadingLight& light, const cv::Mat& fixed, const cv::Mat& guide) {
  return clampedToOne((fillSmoothly(light.cast, fixed, guide, kRatioEdge) - .4) / .3);
}

}  // namespace swaplight
