#include "core/solve/estimators/single_light.h"

#include <algorithm>
#include <cmath>

namespace swaplight {

void SingleLight::estimate(const PixelRun& in, const SolvedRun& out) const {
  const LightingMatrix& lighting = m_context.lighting;
  const float freedom = float(std::max(3 * lighting.shots - 3, 1));
  for (int p = 0; p < in.count; ++p) {
    float bestMisfit = INFINITY;
    float bestRho[3] = {};
    float bestVariance = 0;
    int best = 0;
    for (int i = 0; i < lighting.lights; ++i) {
      float misfit = 0;
      float variance = 0;
      float rho[3];
      for (int c = 0; c < 3; ++c) {
        float yy = 0;
        float ly = 0;
        float ll = 1e-20F;
        for (int k = 0; k < lighting.shots; ++k) {
          const float y = in.signal[k][c][p];
          if (!(y == y)) continue;
          const float w = 1 / m_context.noise.variance(y);
          const float l = lighting.color(k, i)[c];
          yy += w * y * y, ly += w * l * y, ll += w * l * l;
        }
        rho[c] = std::max(ly / ll, 0.0F);
        misfit += yy - ly * rho[c];
        variance += 1 / ll;
      }
      if (misfit < bestMisfit) {
        bestMisfit = misfit, best = i, bestVariance = variance;
        std::copy_n(rho, 3, bestRho);
      }
    }
    const float total = bestRho[0] + bestRho[1] + bestRho[2];
    for (int i = 0; i < lighting.lights; ++i)
      for (int c = 0; c < 3; ++c) out.contribution[i][c][p] = i == best ? bestRho[c] : 0;
    if (out.residual) out.residual[p] = std::sqrt(std::max(bestMisfit, 0.0F) / freedom);
    if (out.sigma) out.sigma[p] = std::min(100.0F, std::sqrt(bestVariance) / std::max(total, 1e-9F));
  }
}

}  // namespace swaplight
