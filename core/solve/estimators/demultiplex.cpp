#include "core/solve/estimators/demultiplex.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/linear/decompositions.h"
#include "core/solve/estimators/demultiplex_kernel.h"

namespace swaplight {
namespace {

constexpr double kSingular = 1e-4;

}  // namespace

Demultiplex::Demultiplex(const EstimatorContext& context, Bound bound)
    : m_lights(context.lighting.lights), m_shots(context.lighting.shots), m_bound(bound), m_context(context) {
  if (m_shots < m_lights)
    throw InputError(
        "{} lights cannot be demultiplexed from {} shots, one for each light is needed; use the model "
        "lambert (--model)",
        m_lights, m_shots);
  for (int c = 0; c < 3; ++c) {
    Eigen::MatrixXd matrix = context.lighting.matrix(c);
    // The mean signal of a shot sets its mean noise: proportional to the light in it.
    Eigen::VectorXd weight(m_shots);
    for (int k = 0; k < m_shots; ++k)
      weight[k] = 1 / std::sqrt(double(context.noise.variance(0.2F * float(matrix.row(k).sum() / m_lights))));
    if (m_shots == m_lights) weight.setOnes();
    const Eigen::MatrixXd weighted = weight.asDiagonal() * matrix;
    const SingularValues svd = singularValues(weighted);
    const Eigen::VectorXd& s = svd.values;
    Eigen::VectorXd inverse = Eigen::VectorXd::Zero(m_lights);
    const bool usable = s[m_lights - 1] > kSingular * s[0];
    for (int i = 0; i < m_lights; ++i)
      if (s[i] > kSingular * s[0] && s[0] > 0) inverse[i] = 1 / s[i];
    const Eigen::MatrixXd pseudo = svd.v * inverse.asDiagonal() * svd.u.transpose() * weight.asDiagonal();
    const Eigen::MatrixXd gram =
        weighted.transpose() * weighted +
        (usable ? 0.0 : 1e-6 * s[0] * s[0] + 1e-12) * Eigen::MatrixXd::Identity(m_lights, m_lights);
    const Eigen::MatrixXd adjoint = weighted.transpose() * weight.asDiagonal();
    for (int i = 0; i < m_lights; ++i) {
      for (int k = 0; k < m_shots; ++k) {
        m_inverse[c].push_back(float(pseudo(i, k)));
        m_adjoint[c].push_back(adjoint(i, k));
      }
      for (int j = 0; j < m_lights; ++j) m_gram[c].push_back(gram(i, j));
    }
  }
}

void Demultiplex::estimate(const PixelRun& in, const SolvedRun& out) const {
  for (int c = 0; c < 3; ++c) {
    DemultiplexRun run{m_lights, m_shots, in.count, m_inverse[c].data()};
    for (int k = 0; k < m_shots; ++k) run.in[k] = in.signal[k][c];
    for (int i = 0; i < m_lights; ++i) run.out[i] = out.contribution[i][c];
    bool negative = false;
    SWAPLIGHT_KERNEL(demultiplexRun)(run, m_bound == Bound::Clamp ? nullptr : &negative);
    if (!negative) continue;
    for (int p = 0; p < in.count; ++p) {
      float lowest = 0;
      for (int i = 0; i < m_lights; ++i) lowest = std::min(lowest, run.out[i][p]);
      if (lowest >= 0) continue;
      float pixel[kMaxShots];
      float x[kMaxLights];
      for (int k = 0; k < m_shots; ++k) pixel[k] = run.in[k][p];
      solveBounded(pixel, c, x);
      for (int i = 0; i < m_lights; ++i) run.out[i][p] = x[i];
    }
  }
  assess(in, out);
}

void Demultiplex::assess(const PixelRun& in, const SolvedRun& out) const {
  if (!out.residual && !out.sigma) return;
  const LightingMatrix& lighting = m_context.lighting;
  const float freedom = float(std::max(3 * (m_shots - m_lights), 1));
  std::vector<float> squared[3];
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < m_shots; ++k) {
      float sum = 0;
      for (int i = 0; i < m_lights; ++i)
        sum += m_inverse[c].data()[i * m_shots + k] * m_inverse[c].data()[i * m_shots + k];
      squared[c].push_back(sum / float(m_lights));
    }
  for (int p = 0; p < in.count; ++p) {
    float misfit = 0;
    float variance = 0;
    float total = 0;
    for (int c = 0; c < 3; ++c) {
      for (int i = 0; i < m_lights; ++i) total += out.contribution[i][c][p];
      for (int k = 0; k < m_shots; ++k) {
        float predicted = 0;
        for (int i = 0; i < m_lights; ++i) predicted += lighting.color(k, i)[c] * out.contribution[i][c][p];
        const float noise = m_context.noise.variance(predicted);
        const float residual = in.signal[k][c][p] - predicted;
        misfit += residual * residual / noise;
        variance += squared[c][size_t(k)] * noise;
      }
    }
    if (out.residual) out.residual[p] = std::min(std::sqrt(misfit / freedom), 1e6F);
    if (out.sigma) out.sigma[p] = std::min(std::sqrt(variance) / std::max(total, 1e-9F), 100.0F);
  }
}

void Demultiplex::solveBounded(const float* y, int channel, float* x) const {
  const int n = m_lights;
  const double* gram = m_gram[channel].data();
  double right[kMaxLights];
  for (int i = 0; i < n; ++i) {
    right[i] = 0;
    for (int k = 0; k < m_shots; ++k) right[i] += m_adjoint[channel].data()[i * m_shots + k] * y[k];
  }
  // Lights are either free or held at zero; those on the wrong side change sides, all at once while that
  // helps, then one by one (which cannot cycle).
  bool held[kMaxLights] = {};
  double value[kMaxLights];
  double slope[kMaxLights];
  int fewest = n + 1;
  int patience = 3;
  for (int round = 0; round < 8 * n; ++round) {
    int index[kMaxLights];
    int free = 0;
    for (int i = 0; i < n; ++i)
      if (!held[i]) index[free++] = i;
    // Cholesky of the free part of the normal matrix.
    double l[kMaxLights][kMaxLights];
    double z[kMaxLights];
    for (int a = 0; a < free; ++a) {
      for (int b = 0; b <= a; ++b) {
        double sum = gram[index[a] * n + index[b]];
        for (int k = 0; k < b; ++k) sum -= l[a][k] * l[b][k];
        l[a][b] = a == b ? std::sqrt(std::max(sum, 1e-300)) : sum / l[b][b];
      }
      double sum = right[index[a]];
      for (int k = 0; k < a; ++k) sum -= l[a][k] * z[k];
      z[a] = sum / l[a][a];
    }
    std::fill_n(value, n, 0.0);
    for (int a = free - 1; a >= 0; --a) {
      double sum = z[a];
      for (int k = a + 1; k < free; ++k) sum -= l[k][a] * value[index[k]];
      value[index[a]] = sum / l[a][a];
    }
    int wrong = 0;
    int last = -1;
    bool isWrong[kMaxLights];
    for (int i = 0; i < n; ++i) {
      slope[i] = -right[i];
      for (int j = 0; j < n; ++j) slope[i] += gram[i * n + j] * value[j];
      isWrong[i] = held[i] ? slope[i] < -1e-12 * gram[i * n + i] : value[i] < 0;
      if (isWrong[i]) ++wrong, last = i;
    }
    if (wrong == 0) break;
    const bool all = wrong < fewest || patience-- > 0;
    fewest = std::min(fewest, wrong);
    for (int i = 0; i < n; ++i)
      if (isWrong[i] && (all || i == last)) held[i] = !held[i];
  }
  for (int i = 0; i < n; ++i) x[i] = float(std::max(value[i], 0.0));
}

}  // namespace swaplight
