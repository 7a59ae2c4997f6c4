#pragma once

#include <opencv2/core.hpp>

#include "core/shadow/evidence/shadow_tuning.h"

namespace swaplight {

/// What a mean is where nothing is near: `value`, with as much weight as this share of what is around.
struct Otherwise {
  float value = 0;
  float weight = 1e-6f;
};

/// The mean of `x` over the pixels around that `where` (0 or 1) chooses, not across the guide's edges (Gastal
/// and Oliveira 2011). Float pictures, the guide with three channels; `radius` in pixels.
[[nodiscard]] cv::Mat guidedMean(const cv::Mat& x, const cv::Mat& where, const cv::Mat& guide, double radius,
                                 const OtherLightsTuning& tuning, const Otherwise& otherwise = {});

}  // namespace swaplight
