#pragma once

#include <vector>

#include "core/shadow/evidence/shadow_evidence.h"
#include "core/shadow/evidence/shadow_tuning.h"

namespace swaplight {

/// What the other lights show of the surfaces that one light falls on.
struct OtherLights {
  cv::Mat rgb;   ///< the sum of their contributions
  cv::Mat grey;  ///< its mean over the channels
  /// 8-bit: not 0 where at least one of them reaches the surface, and is bright enough to tell.
  cv::Mat known;

  /// A light's grey over theirs at a smaller size, from the pixels that `mask` (0 or 1, float) chooses.
  [[nodiscard]] cv::Mat ratioOf(const cv::Mat& own, const cv::Mat& mask, cv::Size size) const;
};

/// `visibilities`: of all lights of the set, 0..1; at the borders of what is known, `rim` pixels are left
/// out.
[[nodiscard]] OtherLights otherLights(const SetEvidence& set, const std::vector<cv::Mat>& visibilities,
                                      size_t light, int rim, const OtherLightsTuning& tuning = {});

/// The other lights' sum again, each of them as far as it shines on the surfaces around that `lit` (0 or 1,
/// float, of any smaller size) chooses. A light's ratio to the others that was taken there says nothing of a
/// light that does not shine there: a back light on hair would count as much of the key as it does of the
/// fill. Near those surfaces the sum is about what it was.
[[nodiscard]] cv::Mat lightsAround(const SetEvidence& set, const std::vector<cv::Mat>& visibilities,
                                   size_t light, const cv::Mat& lit, const OtherLightsTuning& tuning = {});

}  // namespace swaplight
