#include "core/solve/estimators/gloss_fit.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/solve/estimators/run_scratch.h"
#include "core/solve/model/solved_planes.h"

namespace swaplight {

GlossFit::GlossFit(const EstimatorContext& context) : m_matte(context) {
  const LightingMatrix& lighting = context.lighting;
  if (!fits(lighting))
    throw InputError(
        "model gloss needs {} shots of {} lights, there are {}: photograph more, or use the model "
        "lambert, transport or auto (--model)",
        (2 * lighting.lights + 4) / 3, lighting.lights, lighting.shots);
  for (int c = 0; c < 3; ++c) m_seen[size_t(c)] = !lighting.matrix(c).isZero();
  m_plan.lights = lighting.lights;
  m_plan.shots = lighting.shots;
  m_plan.constant = context.noise.constant;
  m_plan.linear = context.noise.linear;
  m_plan.square = context.noise.square;
  for (int k = 0; k < lighting.shots; ++k)
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < lighting.lights; ++i) m_plan.color.push_back(lighting.color(k, i)[c]);
}

void GlossFit::estimate(const PixelRun& in, const SolvedRun& out) const {
  const int n = m_plan.lights;
  const MatteScratch matte(n, in.count);
  m_matte.fit(in, matte.run());
  const SolvedPlanes planes(n, size_t(in.count));
  const SolvedRun& solved = planes.run();
  SWAPLIGHT_KERNEL(fitGloss)(m_plan, in, matte.run(), solved);
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < n; ++i) {
      if (m_seen[size_t(c)])
        std::copy_n(solved.contribution[i][c], in.count, out.contribution[i][c]);
      else
        std::fill_n(out.contribution[i][c], in.count, 0.0F);  // no light shows it
    }
  const float freedom = float(std::max(3 * m_plan.shots - 2 * n - 2, 1));
  for (int p = 0; p < in.count; ++p) {
    if (out.residual) out.residual[p] = std::sqrt(solved.residual[p] / freedom);
    if (out.sigma) out.sigma[p] = std::sqrt(std::min(solved.sigma[p], 1e4F));
  }
}

}  // namespace swaplight
