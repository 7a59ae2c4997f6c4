#pragma once

#include <array>

#include "core/solve/estimators/gloss_kernel.h"
#include "core/solve/estimators/matte_fit.h"

namespace swaplight {

/// Estimator `dichromatic`, model gloss: T[i][c] = beta[i] rho[c] + g[i], a matte surface and a highlight of
/// each light's own colour (Shafer 1985). Gauss-Newton from the matte fit over rho, beta and g, all >= 0,
/// weights from the matte fit's signal; a weak Gaussian prior on g (4 reflectances wide) decides where a grey
/// surface leaves beta and g undetermined: their sum, T, is not. 2 N + 2 unknowns of 3 K values.
class GlossFit final : public Estimator {
 public:
  /// Throws InputError where the shots are too few: 3 K < 2 N + 2.
  explicit GlossFit(const EstimatorContext& context);
  void estimate(const PixelRun& in, const SolvedRun& out) const override;

  /// Whether there are shots enough.
  [[nodiscard]] static bool fits(const LightingMatrix& lighting) {
    return 3 * lighting.shots >= 2 * lighting.lights + 2;
  }

 private:
  MatteFit m_matte;
  GlossPlan m_plan;
  std::array<bool, 3> m_seen{};
};

}  // namespace swaplight
