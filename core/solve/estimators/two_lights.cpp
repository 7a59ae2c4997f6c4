#include "core/solve/estimators/two_lights.h"

#include <cmath>

#include "core/base/error.h"
#include "core/solve/estimators/run_scratch.h"
#include "core/solve/estimators/two_lights_kernel.h"

namespace swaplight {
namespace {

constexpr int kSteps = 1000;

}  // namespace

float betaByBruteForce(const float shot1[3], const float shot2[3], const float color[2][2][3]) {
  float best = 0;
  float smallest = INFINITY;
  for (int step = 0; step <= kSteps; ++step) {
    const float beta = float(step) / kSteps;
    float error = 0;
    for (int c = 0; c < 3; ++c) {
      const float i1 = beta * color[0][0][c] + (1 - beta) * color[0][1][c];
      const float i2 = beta * color[1][0][c] + (1 - beta) * color[1][1][c];
      const float difference = shot1[c] * i2 - shot2[c] * i1;
      error += difference * difference;
    }
    if (error < smallest) {
      smallest = error;
      best = beta;
    }
  }
  return best;
}

TwoLights::TwoLights(const EstimatorContext& context, BetaSearch search, Reflectance reflectance)
    : m_fit(context), m_search(search), m_reflectance(reflectance) {
  if (context.lighting.lights != 2 || context.lighting.shots != 2)
    throw InputError(
        "brute-force, published and closed-form need two lights in two photographs; this capture has {} in "
        "{}: use the solver maximum-likelihood (--solver)",
        context.lighting.lights, context.lighting.shots);
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 2; ++i)
      for (int c = 0; c < 3; ++c) m_color[k][i][c] = context.lighting.color(k, i)[c];
}

void TwoLights::estimate(const PixelRun& in, const SolvedRun& out) const {
  TwoLightColors l;
  for (int c = 0; c < 3; ++c) {
    l.a[c] = m_color[0][0][c], l.b[c] = m_color[0][1][c];
    l.c[c] = m_color[1][0][c], l.d[c] = m_color[1][1][c];
  }
  if (m_search == BetaSearch::ClosedForm) {
    SWAPLIGHT_KERNEL(closedFormRun)(in, out, l, m_reflectance == Reflectance::Published);
    assess(in, out);
    return;
  }
  for (int p = 0; p < in.count; ++p) {
    float y1[3], y2[3];
    for (int c = 0; c < 3; ++c) y1[c] = in.signal[0][c][p], y2[c] = in.signal[1][c][p];
    const float beta = betaByBruteForce(y1, y2, m_color);
    for (int c = 0; c < 3; ++c) {
      const float g1 = beta * l.a[c] + (1 - beta) * l.b[c];
      const float rho = std::fmax(y1[c] / (g1 + 0.01F), 0.0F);
      out.contribution[0][c][p] = beta * rho;
      out.contribution[1][c][p] = (1 - beta) * rho;
    }
  }
  assess(in, out);
}

void TwoLights::assess(const PixelRun& in, const SolvedRun& out) const {
  if (!out.residual && !out.sigma) return;
  MatteScratch scratch(2, in.count);
  scratch.readShares(2, in.count, out);
  m_fit.assess(in, scratch.run());
  writeQuality(scratch.run(), m_fit.freedom(), in.count, out);
}

}  // namespace swaplight
