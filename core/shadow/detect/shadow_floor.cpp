#include "core/shadow/detect/shadow_floor.h"

#include <algorithm>

#include "core/shadow/detect/guided_mean.h"
#include "core/shadow/detect/shadow_pictures.h"

namespace swaplight {
namespace {

// Lengths are in reference units (see referenceUnit).
constexpr float kInside = .02f;          // visibility (as divided) below which a pixel lies inside a shadow
constexpr float kDepth = 8;              // pixels from there to the shadow's edge
constexpr int kFewest = 100;             // pixels inside, to say anything
constexpr float kReach = 20;             // pixels over which the floor is the mean of what is around
constexpr float kOverall = .02f;         // weight of the whole picture's floor
constexpr float kSpreadOfMiddle = 1.5f;  // standard deviation over the median of absolute deviations
constexpr double kHigh = .9;             // share of the pixels inside that are below `high`
// How far above the floor a light reaches a surface: in floors, standard deviations, and shares of what
// would arrive without a shadow; and `high` must be passed by this factor.
constexpr float kFloors = 2.5f, kSpreads = 2.5f, kShare = .004f, kAboveHigh = 1.2f;
// Shadows this dark (of what would arrive without them) are black but for noise, and how much less so they
// may be.
constexpr float kBlack = .006f, kBlackRamp = .006f;
constexpr float kRamp = .5f;  // over how much more of that it becomes certain
constexpr float kLeastRatio = 1e-6f;
constexpr float kStep = .12f;      // of the unshadowed ratio, a pixel: the outline of a thing
constexpr float kStepWidth = 3.5;  // pixels around one that it tells nothing about

}  // namespace

std::optional<ShadowFloor> shadowFloor(const cv::Mat& ratio, const cv::Mat& divided, const cv::Mat& known,
                                       const cv::Mat& guide) {
  const float unit = referenceUnit(ratio);
  cv::Mat depth;
  cv::distanceTransform((divided < kInside) | ~known, depth, cv::DIST_L2, cv::DIST_MASK_5);
  const cv::Mat inside = known & (divided < kInside) & (depth > kDepth * unit);
  if (cv::countNonZero(inside) < kFewest) return std::nullopt;

  ShadowFloor floor;
  floor.ratio =
      guidedMean(ratio, asFloat(inside), guide, kReach * unit, {percentile(ratio, .5, inside), kOverall});
  floor.high = percentile(ratio, kHigh, inside);
  floor.spread = kSpreadOfMiddle * percentile(cv::abs(ratio - floor.ratio), .5, inside);
  return floor;
}

cv::Mat reachedAbove(const ShadowFloor& floor, const cv::Mat& ratio, const cv::Mat& unshadowed,
                     const cv::Mat& divided, const cv::Mat& known) {
  const float unit = referenceUnit(ratio);
  const cv::Mat shadow = known & (divided < .5);
  const float darkness = percentile(floor.ratio / cv::max(unshadowed, kLeastRatio), .5, shadow);
  const float black = std::clamp((kBlack + kBlackRamp - darkness) / kBlackRamp, 0.f, 1.f);
  cv::Mat least = cv::max(kShare * unshadowed, kSpreads * floor.spread) + kFloors * floor.ratio;
  cv::max(least, cv::Mat(kAboveHigh * floor.high - floor.ratio), least);
  cv::Mat reached = clampedToOne((ratio - floor.ratio - least) / (kRamp * least));

  cv::Mat steps = sizeOf(slopesOf(ratio)) > kStep / unit * unshadowed;
  cv::dilate(steps, steps, disk(kStepWidth * unit));
  reached.setTo(0, ~known | steps);
  return reached * black;
}

}  // namespace swaplight
