#pragma once

#include <opencv2/core.hpp>

#include "core/shadow/evidence/shadow_tuning.h"
#include "core/shadow/odds/umbra_network.h"

namespace swaplight {

/// What was measured of a light's visibility (0..1, 32-bit float), with what the odds say of it, which are of
/// a smaller picture: where they say umbra it is 0, where lit 1, and in between what they say is seen, beside
/// what was measured as far as that is `told` (of RefinedVisibility). Along their borders, which they know to
/// their own pixel only, what was measured stays. Odds of empty pictures change nothing.
[[nodiscard]] cv::Mat weighedVisibility(const cv::Mat& measured, const cv::Mat& told, const LightOdds& odds,
                                        const ShadowRegionsTuning& tuning = {});

}  // namespace swaplight
