#include "core/shadow/detect/shadow_floor.h"

#include <algorithm>

#include "core/shadow/evidence/guided_mean.h"
#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

constexpr float kLeastRatio = 1e-6f;

}  // namespace

std::optional<ShadowFloor> shadowFloor(const cv::Mat& ratio, const cv::Mat& divided, const cv::Mat& known,
                                       const cv::Mat& guide, const ShadowTuning& tuning) {
  const float unit = referenceUnit(ratio);
  cv::Mat depth;
  cv::distanceTransform((divided < tuning.floor.inside) | ~known, depth, cv::DIST_L2, cv::DIST_MASK_5);
  const cv::Mat inside = known & (divided < tuning.floor.inside) & (depth > tuning.floor.depth * unit);
  if (cv::countNonZero(inside) < tuning.floor.fewest) return std::nullopt;

  ShadowFloor floor;
  floor.ratio = guidedMean(ratio, asFloat(inside), guide, tuning.floor.reach * unit, tuning.others,
                           {percentile(ratio, .5, inside), tuning.floor.overall});
  floor.high = percentile(ratio, tuning.floor.high, inside);
  floor.spread = tuning.floor.spreadOfMiddle * percentile(cv::abs(ratio - floor.ratio), .5, inside);
  return floor;
}

cv::Mat reachedAbove(const ShadowFloor& floor, const cv::Mat& ratio, const cv::Mat& unshadowed,
                     const cv::Mat& divided, const cv::Mat& known, const ShadowFloorTuning& tuning) {
  const float unit = referenceUnit(ratio);
  const cv::Mat shadow = known & (divided < .5);
  const float darkness = percentile(floor.ratio / cv::max(unshadowed, kLeastRatio), .5, shadow);
  const float black = std::clamp((tuning.black + tuning.blackRamp - darkness) / tuning.blackRamp, 0.f, 1.f);
  cv::Mat least =
      cv::max(tuning.share * unshadowed, tuning.spreads * floor.spread) + tuning.floors * floor.ratio;
  cv::max(least, cv::Mat(tuning.aboveHigh * floor.high - floor.ratio), least);
  cv::Mat reached = clampedToOne((ratio - floor.ratio - least) / (tuning.ramp * least));

  cv::Mat steps = sizeOf(slopesOf(ratio)) > tuning.step / unit * unshadowed;
  cv::dilate(steps, steps, disk(tuning.stepWidth * unit));
  reached.setTo(0, ~known | steps);
  return reached * black;
}

}  // namespace swaplight
