#pragma once

#include <span>

#include "core/color/rgb.h"
#include "core/solve/model/lighting_matrix.h"
#include "core/solve/model/noise_model.h"

namespace swaplight {

/// The Cramer-Rao bound of a matte pixel on its own: what an unbiased estimator cannot do better than. The
/// inverse of the Fisher information J' V^-1 J of rho and all betas but the last (docs/theory.md).
struct MatteBound {
  double beta = 0;          ///< mean squared error of the proportions, averaged over the lights
  double contribution = 0;  ///< squared error of T, summed over lights and channels
};

/// `beta` sums to 1; `rho` is the sum of all lights. Values at and above `clip` tell nothing. Infinite where
/// nothing is known.
[[nodiscard]] MatteBound matteBound(const LightingMatrix& lighting, const NoiseModel& noise, float clip,
                                    std::span<const float> beta, const Rgb& rho);

}  // namespace swaplight
