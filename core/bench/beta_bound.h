#pragma once

#include <span>

#include "core/color/rgb.h"
#include "core/solve/light_plan.h"
#include "core/solve/noise_model.h"

namespace swaplight {

/// The Cramer-Rao bound of a matte pixel's proportions: the smallest mean squared error of beta, averaged
/// over the lights, that an unbiased estimator can have. The inverse of the Fisher information J' V^-1 J of
/// rho and all betas but the last (THEORY 4). `beta` sums to 1; `rho` is the sum of all lights.
[[nodiscard]] double betaBound(const LightPlan& plan, const NoiseModel& noise, std::span<const float> beta,
                               const Rgb& rho);

}  // namespace swaplight
