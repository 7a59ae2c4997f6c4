#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "core/shadow/evidence/shadow_tuning.h"

namespace swaplight {

/// What a light's own shadows show of it: bounced light, and noise.
struct ShadowFloor {
  cv::Mat ratio;     ///< the light's ratio to the others in its shadow, continued from the shadow's inside
  float high = 0;    ///< what the ratio exceeds on few pixels inside shadows
  float spread = 0;  ///< the ratio's standard deviation about it
};

/// `ratio` (of the light to the others, float, at the working size) is known where `known` (8-bit); `divided`
/// is the visibility as first divided, 0..1; `guide` (three channels) has the edges that the floor is not
/// continued over. Nothing where too little of the picture lies well inside a shadow.
[[nodiscard]] std::optional<ShadowFloor> shadowFloor(const cv::Mat& ratio, const cv::Mat& divided,
                                                     const cv::Mat& known, const cv::Mat& guide,
                                                     const ShadowTuning& tuning);

/// 1 where more of the light arrives than its shadows' floor explains, 0 where it does not: to where a
/// surface that turns away sees the last of a light. Not beside steps of the ratio (outlines of things),
/// which the removal of noise has smeared. Where shadows are not black, bounced light cannot be told from the
/// last of a light: 0 everywhere. `unshadowed`: the ratio without the shadow.
[[nodiscard]] cv::Mat reachedAbove(const ShadowFloor& floor, const cv::Mat& ratio, const cv::Mat& unshadowed,
                                   const cv::Mat& divided, const cv::Mat& known,
                                   const ShadowFloorTuning& tuning);

}  // namespace swaplight
