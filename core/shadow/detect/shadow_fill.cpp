#include "core/shadow/detect/shadow_fill.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"
#include "core/shadow/evidence/fading_light.h"
#include "core/shadow/evidence/other_lights.h"
#include "core/shadow/numeric/shadow_pictures.h"
#include "core/shadow/numeric/smooth_fill.h"

namespace swaplight {
namespace {

struct Continued {
  cv::Mat ratio;
  cv::Mat cast;  ///< 0..1: is the shadow nearby cast, or does the shading fall off by itself?
};

// A ratio known where `fixed`, continued. Where it fades out towards the border (shading that falls off, not
// a shadow that is cast) what lies beyond is dark of itself: 0.
Continued continued(const cv::Mat& ratio, const cv::Mat& fixed, const cv::Mat& guide,
                    const ShadowTuning& tuning) {
  const FadingLight fading = fadingLight(ratio, fixed, guide, tuning);
  // The last of a penumbra would pull the continuation down.
  const cv::Mat full = fixed & ((ratio > tuning.fill.leastOfMean * fading.around) | (fading.cast < .5));
  return {cv::max(fillSmoothly(ratio, full, guide, tuning.others.ratioEdge), 0).mul(fading.beyond),
          fading.beyond};
}

}  // namespace

FilledShadow fillShadow(const SetEvidence& set, const std::vector<cv::Mat>& visibilities, const cv::Mat& told,
                        size_t light, const ShadowTuning& tuning) {
  const cv::Mat& own = set.contributions[light];
  const cv::Mat& visibility = visibilities[light];
  const cv::Size full = own.size();
  const cv::Size size = workingSize(full);
  const int rim =
      std::max(2, static_cast<int>(tuning.fill.rim * referenceUnit(own)));  // the faint end of penumbras
  const OtherLights others = otherLights(set, visibilities, light, rim, tuning.others);
  const cv::Mat known = asFloat(others.known);
  cv::Mat sure = visibility > tuning.fill.sure;
  cv::erode(sure, sure, {}, {-1, -1}, rim, cv::BORDER_CONSTANT, cv::Scalar(255));

  // The ratio to the other lights, known where both light the surface, continued into the shadow.
  const cv::Mat both = asFloat(sure & others.known);
  const cv::Mat ownGrey = greyOf(own);
  const cv::Mat ratio = others.ratioOf(ownGrey, both, size);
  const cv::Mat fixed = shrunk(both, size) > .49;
  const cv::Mat otherMean = meanOver(others.rgb, known, size);
  const cv::Mat guide = guideOf(otherMean);
  const auto [smoothRatio, cast] = continued(ratio, fixed, guide, tuning);

  // The contribution without its shadow, coarsely; what no light shows is continued from its surroundings.
  const cv::Mat knownSmall = shrunk(known, size) > .49;
  const cv::Mat shadowSmall = shrunk(asFloat(~sure), size) > .3;
  cv::Mat coarse = shrunk(own, size);
  cv::Mat(spread(smoothRatio).mul(otherMean)).copyTo(coarse, shadowSmall & knownSmall);
  const cv::Mat shown = ~(shadowSmall & ~knownSmall);
  const cv::Mat picture = guideOf(shrunk(own + others.rgb, size));
  cv::Mat channels[3];
  cv::split(coarse, channels);
  const SmoothFill fill(shown, picture, tuning.fill.pictureEdge);
  parallelEach(3, [&](int c) { channels[c] = cv::max(fill.of(channels[c]), 0); });
  cv::merge(channels, 3, coarse);

  // In full detail where the other lights have it.
  cv::Mat unshadowed = grown(coarse, full);
  cv::Mat detailed;
  cv::erode(others.known, detailed, {});
  cv::Mat(spread(grown(smoothRatio, full)).mul(others.rgb)).copyTo(unshadowed, detailed);

  // What is seen nearly in whole needs no continuation.
  const cv::Mat continuedShare = 1 / cv::max(visibility, tuning.fill.sure) - 1;
  const auto missingOf = [&](const cv::Mat& whole) {
    cv::Mat missing = whole - own;
    cv::max(missing, 0, missing);
    cv::Mat(own.mul(spread(continuedShare))).copyTo(missing, sure);
    return missing;
  };
  cv::Mat missing = missingOf(unshadowed);

  // Where most of the light arrives, what is missing says how much of it exactly: bounced light counts
  // little.
  FilledShadow filled{cv::Mat(), visibility.clone()};
  const cv::Mat present = ownGrey + tuning.fill.leastGrey;
  cv::Mat seenShare;
  cv::divide(present, present + greyOf(missing), seenShare);
  seenShare = cv::min(cv::max(seenShare, tuning.fill.barelySeen), visibility);
  seenShare += told.mul(visibility - seenShare);
  seenShare.copyTo(filled.visibility, visibility > tuning.fill.barelySeen);
  // Shading that falls off by itself is dim, but sees all of the light up to its end.
  const cv::Mat reached = asFloat(visibility > tuning.fill.reached);
  cv::Mat ending = reached + grown(cast, full).mul(filled.visibility - reached);
  ending += told.mul(filled.visibility - ending);
  ending.copyTo(filled.visibility, others.known);
  filled.visibility.setTo(1, sure & (visibility > tuning.fill.allSeen));

  // What fills it: of lights alone that shine where the ratio was taken.
  if (set.contributions.size() > 2) {
    cv::Mat(spread(grown(smoothRatio, full))
                .mul(lightsAround(set, visibilities, light, asFloat(fixed), tuning.others)))
        .copyTo(unshadowed, detailed);
    missing = missingOf(unshadowed);
  }
  // Bounced light is no part of it where it can be told apart: in the umbra.
  cv::divide(missing, spread(cv::max(1 - filled.visibility, 1 - tuning.fill.fullySeen)), filled.direct);
  const cv::Mat lit = clampedToOne((filled.visibility - tuning.fill.barelySeen) /
                                   (tuning.fill.fullySeen - tuning.fill.barelySeen));
  filled.direct += spread(lit).mul(own + missing - filled.direct);
  return filled;
}

}  // namespace swaplight
