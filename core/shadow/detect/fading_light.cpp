#include "core/shadow/detect/fading_light.h"

#include <algorithm>

#include "core/shadow/detect/guided_mean.h"
#include "core/shadow/detect/other_lights.h"
#include "core/shadow/detect/poisson.h"
#include "core/shadow/detect/shadow_pictures.h"

namespace swaplight {

FadingLight fadingLight(const cv::Mat& ratio, const cv::Mat& fixed, const cv::Mat& guide) {
  const cv::Mat where = asFloat(fixed);
  const double near = std::max(2., 3. * referenceUnit(ratio));
  FadingLight light;
  light.around = cv::max(guidedMean(ratio, where, guide, 5 * near), 1e-6);
  light.cast = clampedToOne((guidedMean(ratio, where, guide, near) / light.around - .65) / .2);
  return light;
}

cv::Mat castBeyond(const FadingLight& light, const cv::Mat& fixed, const cv::Mat& guide) {
  return clampedToOne((fillSmoothly(light.cast, fixed, guide, kRatioEdge) - .4) / .3);
}

}  // namespace swaplight
