#include "core/shadow/detect/penumbra.h"

#include <algorithm>
#include <cmath>

#include "core/shadow/detect/fading_light.h"
#include "core/shadow/detect/other_lights.h"
#include "core/shadow/detect/poisson.h"
#include "core/shadow/detect/shadow_floor.h"
#include "core/shadow/detect/shadow_pictures.h"

namespace swaplight {
namespace {

// Lengths are in reference units (see referenceUnit).
constexpr float kCalm = .015f;      // log of the ratio, a pixel: less is no edge of a shadow
constexpr float kSmoothing = 1.2f;  // pixels: of the ratio, before its slope is taken
constexpr float kRim = 2;           // pixels beside a shadow that are not taken for fully lit
constexpr float kReach = 45;        // pixels from a shadow to the end of its penumbra
constexpr float kWindow = 6;        // pixels around one over which slopes are added up
constexpr float kPooling = 12;      // pixels around one over which edges are of one kind
constexpr float kSharp = .3f;       // log step of the other lights that belongs to an outline or a print
constexpr float kEdgeLow = .1f;     // visibilities between which a pixel belongs to an edge
constexpr float kEdgeHigh = .95f;
constexpr float kFewest = 2.5f;  // pixels of an edge in the window, to say anything
// The other lights' slope (log) over this light's (visibility): up to here a cast shadow, or from here on a
// surface that turns away; and over how much one becomes the other.
constexpr float kCast = .2f, kCastRamp = .08f;
constexpr float kTurns = .3f, kTurnsRamp = .15f;
constexpr float kLeastCast = .1f, kLeastTurning = .3f, kLeastRamp = .2f;  // share of the edge around a pixel
// Visibilities (of the division) between which a surface that turns away loses the light.
constexpr float kEnds = .05f, kEndsRamp = .35f;
constexpr int kOthersRim = 2;          // pixels beside the other lights' own shadows that tell nothing
constexpr float kFadeDoubt = .3f;      // how much less a surface turns away where the light does not fade
constexpr float kMostBounced = .3f;    // of what would arrive without the shadow
constexpr float kFullyDivided = .95f;  // visibility (of the division) of pixels surely lit

cv::Mat mean(const cv::Mat& x, int radius) {
  cv::Mat out;
  cv::blur(x, out, {2 * radius + 1, 2 * radius + 1}, {-1, -1}, cv::BORDER_REPLICATE);
  return out;
}

// Where the edges of shadows are, and of which kind: shares of the edge around each pixel, 0..1.
struct EdgeKinds {
  cv::Mat cast, turning;
};

EdgeKinds edgeKinds(const cv::Mat& visibility, const cv::Mat& otherLog, const cv::Mat& known, float unit) {
  const cv::Mat edge = known & (visibility > kEdgeLow) & (visibility < kEdgeHigh);
  cv::Mat inside;
  cv::erode(known, inside, {}, {-1, -1}, kOthersRim, cv::BORDER_CONSTANT, cv::Scalar(255));
  const cv::Mat counts = asFloat(edge & inside & (sizeOf(slopesOf(otherLog)) < kSharp));
  const int radius = static_cast<int>(std::lround(kWindow * unit));
  const auto slopeAround = [&](const cv::Mat& picture) {
    const Slopes slopes = slopesOf(mean(mean(picture, 1), 1));
    return sizeOf({mean(slopes.x.mul(counts), radius), mean(slopes.y.mul(counts), radius)});
  };
  const cv::Mat unevenness = slopeAround(otherLog) / cv::max(slopeAround(cv::min(visibility, 1.2f)), 1e-6f);
  const float fewest = kFewest / static_cast<float>((2 * radius + 1) * (2 * radius + 1));
  const cv::Mat told = mean(counts, radius) >= fewest;

  const cv::Mat weight = asFloat(edge) + 1e-4f;
  const int pooling = static_cast<int>(kPooling * unit);
  const cv::Mat around = mean(weight, pooling);
  const auto pooled = [&](const cv::Mat& kind, float least) {
    cv::Mat share = clampedToOne(kind);
    share.setTo(0, ~told);
    share = mean(share.mul(weight), pooling) / around;
    return mean(clampedToOne((share - least) / kLeastRamp), 1);
  };
  EdgeKinds kinds;
  kinds.cast = pooled((kCast - unevenness) / kCastRamp, kLeastCast);
  kinds.turning = pooled((unevenness - kTurns) / kTurnsRamp, kLeastTurning);
  kinds.turning = kinds.turning.mul(1 - kinds.cast);
  return kinds;
}

// Where all of the light arrives: known, not beside a shadow, and where the ratio hardly changes.
cv::Mat fullyLit(const cv::Mat& ratio, const cv::Mat& distance, const cv::Mat& known, float unit) {
  cv::Mat log = ratio + 1e-4f;
  cv::log(log, log);
  cv::GaussianBlur(log, log, {}, kSmoothing * unit);
  cv::Mat full = known & (distance > kRim * unit) & (sizeOf(slopesOf(log)) < kCalm / unit);
  cv::morphologyEx(full, full, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3}));
  return full;
}

}  // namespace

RefinedVisibility refineVisibility(const SetEvidence& set, const std::vector<cv::Mat>& visibilities,
                                   size_t light) {
  const cv::Mat& visibility = visibilities[light];
  const cv::Size full = visibility.size();
  const cv::Size size = workingSize(full);
  const OtherLights others = otherLights(set, visibilities, light, 1);
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
  const cv::Mat fixed = fullyLit(ratio, distance, known, unit);
  const cv::Mat unshadowed = cv::max(fillSmoothly(ratio, fixed, guide, kRatioEdge), 1e-6);

  EdgeKinds kinds = edgeKinds(ratio / unshadowed, greyOf(guide), known, unit);
  const cv::Mat lit = known & (divided > kFullyDivided);
  kinds.turning = kinds.turning.mul(1 - kFadeDoubt * castBeyond(fadingLight(ratio, lit, guide), lit, guide));

  // What the shadow leaves of the light is no part of what passes it.
  const cv::Mat calm = mean(ratio, 1);
  const std::optional<ShadowFloor> floor = shadowFloor(calm, divided, known, guide);
  cv::Mat bounced(size, CV_32F, cv::Scalar(0));
  if (floor) cv::min(floor->ratio, cv::Mat(kMostBounced * unshadowed), bounced);
  const cv::Mat passing = own - grown(bounced, full).mul(others.grey);
  cv::Mat exact;
  cv::divide(passing, grown(unshadowed - bounced, full).mul(others.grey) + 1e-6f, exact);
  exact = clampedToOne(exact);

  cv::Mat open = cv::min(1.5f * grown(asFloat(~fixed & (distance < kReach * unit)), full), 1);
  open.setTo(0, ~others.known);
  const cv::Mat cast = grown(kinds.cast, full).mul(open);
  cv::Mat turning = grown(kinds.turning, full);
  turning.setTo(0, ~others.known);
  cv::Mat refined = visibility + turning.mul(clampedToOne((visibility - kEnds) / kEndsRamp) - visibility);
  refined += cast.mul(exact - refined);
  cv::Mat reached(full, CV_32F, cv::Scalar(0));
  if (floor) {
    const cv::Mat turns = clampedToOne((kinds.turning - kLeastTurning) / kLeastRamp);
    reached = grown(turns.mul(reachedAbove(*floor, calm, unshadowed, divided, known)), full);
    reached.setTo(0, ~others.known);
  }
  return {refined, cv::max(cast, turning), reached};
}

}  // namespace swaplight
