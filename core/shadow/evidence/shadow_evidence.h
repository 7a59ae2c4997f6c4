#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/set/solved_set.h"
#include "core/shadow/evidence/shadow_tuning.h"

namespace swaplight {

/// What a light's contribution says about its shadows, as logarithms (32-bit float pictures).
struct ShadowEvidence {
  /// log of the light's contribution, less half of the reflectance's: dark where the light does not reach,
  /// less so where only the surface is dark.
  cv::Mat level;
  /// log of the light's contribution, less all of the reflectance's: as flat as possible but for shadows.
  cv::Mat shading;
  /// How steep that is where it changes, a pixel, and the part of it that the other lights do not share:
  /// shadows' edges, not printed ones.
  cv::Mat slope, edge;
  /// log of the light's contribution over the sum of the others'.
  cv::Mat ratio;
  bool shines = true;  ///< false: it gives nothing, or nearly nowhere
};

/// What all lights say together.
struct SetEvidence {
  std::vector<ShadowEvidence> lights;
  std::vector<cv::Mat> contributions;  ///< R G B float, noise taken out, in units of `white`
  cv::Mat known;                       ///< 8-bit: not 0 where there is light enough to tell anything
  float white = 1;                     ///< the 99th percentile of the grey of the sum at unit white
};

/// Reflectance is what changes under all lights alike: the gradients of log contributions that the lights
/// share (the smaller of two; the median of three and more, after Weiss, "Deriving intrinsic images from
/// image sequences", ICCV 2001), integrated. Noise is taken out by a local Wiener filter with the set's own
/// sigma.
[[nodiscard]] SetEvidence gatherShadowEvidence(const SolvedSet& set, const Progress& progress = {},
                                               const ShadowEvidenceTuning& tuning = {});

}  // namespace swaplight
