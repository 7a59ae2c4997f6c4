#pragma once

#include <array>
#include <vector>

#include "core/solve/model/lighting_matrix.h"
#include "core/solve/model/solve_options.h"

namespace swaplight {

/// A matte pixel: T[i][c] = shading[i] albedo[c].
struct TypicalPixel {
  std::array<double, 3> albedo{};
  std::array<double, kMaxLights> shading{};
};

/// Pixels as most sets have them: albedo 0.05 .. 0.9, shading 0 .. 0.5 a light (docs/theory.md), spread
/// evenly by a Kronecker sequence: the same on every machine, and few stand for many.
[[nodiscard]] std::vector<TypicalPixel> typicalPixels(int lights, int count);

/// What a plan's photographs will be worth, before they are taken.
struct PlanNoise {
  double contribution = 0;  ///< standard error of T over the RMS of T
  double beta = 0;          ///< standard error of a light's proportion
};

/// The standard errors that a model's estimator will have: the pixels are photographed with noise (of a fixed
/// seed) and solved. The inverse Fisher information says the same where noise is small, but beta and T that
/// are held at >= 0 take errors back, those of all lights at once where a badly conditioned plan has them lie
/// along one mixture of lights. A thousand pixels give the figure to a few per cent.
[[nodiscard]] PlanNoise predictedNoise(const LightingMatrix& lighting, const SensorNoise& noise,
                                       const std::vector<TypicalPixel>& pixels, Model model);

/// What a search compares plans by: the mean squared error of T over the mean square of T by the matte model,
/// from the Fisher information J'V^-1 J, with J the derivative of the shots' 3 K values by (rho, beta) and V
/// the sensor's noise (Cramer-Rao). The pixels' own spread serves as a weak prior: it stands for the bounds
/// beta >= 0, sum 1 that a solver keeps where a pixel is dark, and keeps a degenerate plan finite, hence
/// comparable.
[[nodiscard]] double matteCost(const LightingMatrix& lighting, const SensorNoise& noise,
                               const std::vector<TypicalPixel>& pixels);

/// The same for a free contribution a light and channel: the trace of the inverse Gram matrix L'V^-1 L of
/// each channel, with the pixels' own spread as a prior.
[[nodiscard]] double transportCost(const LightingMatrix& lighting, const SensorNoise& noise,
                                   const std::vector<TypicalPixel>& pixels);

/// The fraction of the typical pixels that would reach full scale in some shot.
[[nodiscard]] double clippedFraction(const LightingMatrix& lighting, const std::vector<TypicalPixel>& pixels);

}  // namespace swaplight
