#pragma once

#include <opencv2/core.hpp>

#include "core/shadow/evidence/shadow_tuning.h"
#include "core/shadow/odds/umbra_network.h"

namespace swaplight {

/// What was measured of a light's visibility (0..1, 32-bit float), with what the odds say of it, which may be
/// of a smaller picture: where they say umbra it is 0, where lit 1, and in between what they say is seen, or
/// what was measured as far as that is well `told` (of RefinedVisibility). Where they say that it is no umbra
/// something is seen. Along their borders, which they know to their own pixel only, and where a strip between
/// umbra and lit is narrow, what was measured stays. Odds of empty pictures change nothing.
[[nodiscard]] cv::Mat weighedVisibility(const cv::Mat& measured, const cv::Mat& told, const LightOdds& odds,
                                        const ShadowRegionsTuning& tuning = {});

}  // namespace swaplight
