#include "core/shadow/detect/penumbra.h"

#include <algorithm>
#include <cmath>

#include "core/shadow/detect/shadow_floor.h"
#include "core/shadow/evidence/fading_light.h"
#include "core/shadow/evidence/other_lights.h"
#include "core/shadow/numeric/shadow_pictures.h"
#include "core/shadow/numeric/smooth_fill.h"

namespace swaplight {
namespace {

cv::Mat mean(const cv::Mat& x, int radius) {
  cv::Mat out;
  cv::blur(x, out, {2 * radius + 1, 2 * radius + 1}, {-1, -1}, cv::BORDER_REPLICATE);
  return out;
}

// Where the edges of shadows are, and of which kind: shares of the edge around each pixel, 0..1.
struct EdgeKinds {
  cv::Mat cast, turning;
};

EdgeKinds edgeKinds(const cv::Mat& visibility, const cv::Mat& otherLog, const cv::Mat& known, float unit,
                    const PenumbraTuning& tuning) {
  const cv::Mat edge = known & (visibility > tuning.edgeLow) & (visibility < tuning.edgeHigh);
  cv::Mat inside;
  cv::erode(known, inside, {}, {-1, -1}, tuning.othersRim, cv::BORDER_CONSTANT, cv::Scalar(255));
  const cv::Mat counts = asFloat(edge & inside & (sizeOf(slopesOf(otherLog)) < tuning.sharp));
  const int radius = static_cast<int>(std::lround(tuning.window * unit));
  const auto slopeAround = [&](const cv::Mat& picture) {
    const Slopes slopes = slopesOf(mean(mean(picture, 1), 1));
    return sizeOf({mean(slopes.x.mul(counts), radius), mean(slopes.y.mul(counts), radius)});
  };
  const cv::Mat unevenness = slopeAround(otherLog) / cv::max(slopeAround(cv::min(visibility, 1.2f)), 1e-6f);
  const float fewest = tuning.fewest / static_cast<float>((2 * radius + 1) * (2 * radius + 1));
  const cv::Mat told = mean(counts, radius) >= fewest;

  const cv::Mat weight = asFloat(edge) + 1e-4f;
  const int pooling = static_cast<int>(tuning.pooling * unit);
  const cv::Mat around = mean(weight, pooling);
  const auto pooled = [&](const cv::Mat& kind, float least) {
    cv::Mat share = clampedToOne(kind);
    share.setTo(0, ~told);
    share = mean(share.mul(weight), pooling) / around;
    return mean(clampedToOne((share - least) / tuning.leastRamp), 1);
  };
  EdgeKinds kinds;
  kinds.cast = pooled((tuning.cast - unevenness) / tuning.castRamp, tuning.leastCast);
  kinds.turning = pooled((unevenness - tuning.turns) / tuning.turnsRamp, tuning.leastTurning);
  kinds.turning = kinds.turning.mul(1 - kinds.cast);
  return kinds;
}

// Where all of the light arrives: known, not beside a shadow, and where the ratio hardly changes.
cv::Mat fullyLit(const cv::Mat& ratio, const cv::Mat& distance, const cv::Mat& known, float unit,
                 const PenumbraTuning& tuning) {
  cv::Mat log = ratio + 1e-4f;
  cv::log(log, log);
  cv::GaussianBlur(log, log, {}, tuning.smoothing * unit);
  cv::Mat full = known & (distance > tuning.rim * unit) & (sizeOf(slopesOf(log)) < tuning.calm / unit);
  cv::morphologyEx(full, full, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3}));
  return full;
}

}  // namespace

RefinedVisibility refineVisibility(const SetEvidence& set, const std::vector<cv::Mat>& visibilities,
                                   size_t light, const ShadowTuning& tuning) {
  const cv::Mat& visibility = visibilities[light];
  const cv::Size full = visibility.size();
  const cv::Size size = workingSize(full);
  const OtherLights others = otherLights(set, visibilities, light, 1, tuning.others);
  const cv::Mat own = greyOf(set.contributions[light]);

  // The ratio, and what it would be without the shadow, at the working size.
  const cv::Mat weight = asFloat(others.known);
  const cv::Mat known = shrunk(weight, size) > .49;
  const cv::Mat ratio = others.ratioOf(own, weight, size);
  const cv::Mat guide = guideOf(meanOver(others.rgb, weight, size));
  const cv::Mat divided = shrunk(visibility, size);
  const float unit = referenceUnit(divided);
  cv::Mat distance;  // from the shadow
  cv::distanceTransform(divided > .5, distance, cv::DIST_L2, cv::DIST_MASK_5);
  const cv::Mat fixed = fullyLit(ratio, distance, known, unit, tuning.penumbra);
  const cv::Mat unshadowed = cv::max(fillSmoothly(ratio, fixed, guide, tuning.others.ratioEdge), 1e-6);

  EdgeKinds kinds = edgeKinds(ratio / unshadowed, greyOf(guide), known, unit, tuning.penumbra);
  const cv::Mat lit = known & (divided > tuning.penumbra.fullyDivided);
  const cv::Mat unfaded = fadingLight(ratio, lit, guide, tuning).beyond;
  kinds.turning = kinds.turning.mul(1 - tuning.penumbra.fadeDoubt * unfaded);

  // What the shadow leaves of the light is no part of what passes it.
  const cv::Mat calm = mean(ratio, 1);
  const std::optional<ShadowFloor> floor = shadowFloor(calm, divided, known, guide, tuning);
  cv::Mat bounced(size, CV_32F, cv::Scalar(0));
  if (floor) cv::min(floor->ratio, cv::Mat(tuning.penumbra.mostBounced * unshadowed), bounced);
  const cv::Mat passing = own - grown(bounced, full).mul(others.grey);
  cv::Mat exact;
  cv::divide(passing, grown(unshadowed - bounced, full).mul(others.grey) + 1e-6f, exact);
  exact = clampedToOne(exact);

  cv::Mat open = cv::min(1.5f * grown(asFloat(~fixed & (distance < tuning.penumbra.reach * unit)), full), 1);
  open.setTo(0, ~others.known);
  const cv::Mat cast = grown(kinds.cast, full).mul(open);
  cv::Mat turning = grown(kinds.turning, full);
  turning.setTo(0, ~others.known);
  cv::Mat refined =
      visibility +
      turning.mul(clampedToOne((visibility - tuning.penumbra.ends) / tuning.penumbra.endsRamp) - visibility);
  refined += cast.mul(exact - refined);
  cv::Mat reached(full, CV_32F, cv::Scalar(0));
  if (floor) {
    const cv::Mat turns =
        clampedToOne((kinds.turning - tuning.penumbra.leastTurning) / tuning.penumbra.leastRamp);
    reached = grown(turns.mul(reachedAbove(*floor, calm, unshadowed, divided, known, tuning.floor)), full);
    reached.setTo(0, ~others.known);
  }
  return {refined, cv::max(cast, turning), reached};
}

}  // namespace swaplight
