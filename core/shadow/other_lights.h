#pragma once

#include <vector>

#include "core/shadow/shadow_evidence.h"

namespace swaplight {

inline constexpr float kRatioEdge = .3f;  ///< log step of the other lights that a ratio is not continued over

/// What the other lights show of the surfaces that one light falls on.
struct OtherLights {
  cv::Mat rgb;   ///< the sum of their contributions
  cv::Mat grey;  ///< its mean over the channels
  cv::Mat
      known;  ///< 8-bit: not 0 where at least one of them reaches the surface, and is bright enough to tell
};

/// `visibilities`: of all lights of the set, 0..1; at the borders of what is known, `rim` pixels are left
/// out.
[[nodiscard]] OtherLights otherLights(const SetEvidence& set, const std::vector<cv::Mat>& visibilities,
                                      size_t light, int rim);

/// A size at which what is smooth is solved: no side longer than 640 pixels.
[[nodiscard]] cv::Size workingSize(cv::Size full);

/// The logarithm of a picture at that size (R G B); what is dark is all alike.
[[nodiscard]] cv::Mat guideOf(const cv::Mat& rgb);

}  // namespace swaplight
