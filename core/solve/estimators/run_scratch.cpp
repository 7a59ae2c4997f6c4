#include "core/solve/estimators/run_scratch.h"

#include <algorithm>
#include <cmath>

#include "core/simd/simd.h"

namespace swaplight {
namespace {

SWAPLIGHT_SIMD(void, multiply,
               (const float* __restrict share, const float* __restrict reflectance, float* __restrict out,
                int count),
               (share, reflectance, out, count)) {
  for (int p = 0; p < count; ++p) out[p] = share[p] * reflectance[p];
}

SWAPLIGHT_SIMD(void, scaledRoot, (const float* __restrict in, float scale, float* __restrict out, int count),
               (in, scale, out, count)) {
  for (int p = 0; p < count; ++p) out[p] = std::sqrt(in[p] * scale);
}

}  // namespace

MatteScratch::MatteScratch(int lights, int count) : m_arena(size_t(count), size_t(lights + 6)) {
  for (int i = 0; i < lights; ++i) m_run.share[i] = m_arena.take();
  for (float*& plane : m_run.reflectance) plane = m_arena.take();
  m_run.misfit = m_arena.take();
  m_run.variance = m_arena.take();
  m_run.shareVariance = m_arena.take();
}

void MatteScratch::readShares(int lights, int count, const SolvedRun& from) const {
  for (int p = 0; p < count; ++p) {
    float total = 0;
    for (int i = 0; i < lights; ++i) {
      m_run.share[i][p] =
          from.contribution[i][0][p] + from.contribution[i][1][p] + from.contribution[i][2][p];
      total += m_run.share[i][p];
    }
    for (int i = 0; i < lights; ++i)
      m_run.share[i][p] = total > 0 ? m_run.share[i][p] / total : 1.0F / float(lights);
  }
}

void writeContributions(const MatteRun& fit, int lights, int count, const SolvedRun& out) {
  for (int i = 0; i < lights; ++i)
    for (int c = 0; c < 3; ++c) multiply(fit.share[i], fit.reflectance[c], out.contribution[i][c], count);
}

void writeQuality(const MatteRun& fit, int freedom, int count, const SolvedRun& out) {
  if (out.residual) scaledRoot(fit.misfit, 1.0F / float(std::max(freedom, 1)), out.residual, count);
  if (out.sigma) scaledRoot(fit.variance, 1, out.sigma, count);
}

}  // namespace swaplight
