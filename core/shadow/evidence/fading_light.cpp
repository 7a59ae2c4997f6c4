#include "core/shadow/evidence/fading_light.h"

#include <algorithm>

#include "core/shadow/evidence/guided_mean.h"
#include "core/shadow/numeric/poisson.h"
#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {

FadingLight fadingLight(const cv::Mat& ratio, const cv::Mat& fixed, const cv::Mat& guide,
                        const ShadowTuning& tuning) {
  const cv::Mat where = asFloat(fixed);
  const double near = std::max(2., tuning.fading.near * referenceUnit(ratio));
  FadingLight light;
  light.around = cv::max(guidedMean(ratio, where, guide, tuning.fading.wide * near, tuning.others), 1e-6);
  const cv::Mat beside = guidedMean(ratio, where, guide, near, tuning.others);
  light.cast = clampedToOne((beside / light.around - tuning.fading.gone) / tuning.fading.goneRamp);
  return light;
}

cv::Mat castBeyond(const FadingLight& light, const cv::Mat& fixed, const cv::Mat& guide,
                   const ShadowTuning& tuning) {
  const cv::Mat continued = fillSmoothly(light.cast, fixed, guide, tuning.others.ratioEdge);
  return clampedToOne((continued - tuning.fading.castFrom) / tuning.fading.castRamp);
}

}  // namespace swaplight
