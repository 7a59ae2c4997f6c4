#include "core/solve/estimators/matte_fit.h"

#include "core/linear/decompositions.h"
#include "core/solve/estimators/run_scratch.h"

namespace swaplight {
namespace {

constexpr double kRidge = 0.03;  // of the first guess, relative to the mean squared colour

}  // namespace

MatteFit::MatteFit(const EstimatorContext& context)
    : m_lights(context.lighting.lights), m_shots(context.lighting.shots) {
  const LightingMatrix& from = context.lighting;
  m_plan.lights = m_lights;
  m_plan.shots = m_shots;
  m_plan.constant = context.noise.constant;
  m_plan.linear = context.noise.linear;
  m_plan.square = context.noise.square;
  Eigen::MatrixXd guess[3];
  int seen = 0;
  for (int c = 0; c < 3; ++c) {
    const Eigen::MatrixXd l = from.matrix(c);
    const Eigen::MatrixXd gram = l.transpose() * l;
    m_plan.seen[size_t(c)] = l.isZero() ? 0.0F : 1.0F;
    seen += !l.isZero();
    const double ridge = kRidge * gram.trace() / m_lights + 1e-12;
    guess[c] = solveSymmetric(gram + ridge * Eigen::MatrixXd::Identity(m_lights, m_lights), l.transpose());
  }
  m_freedom = seen * (m_shots - 1) - (m_lights - 1);
  m_plan.mean.assign(size_t(m_lights) * 3, 0.0F);
  for (int k = 0; k < m_shots; ++k)
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < m_lights; ++i) {
        m_plan.mean.data()[c * m_lights + i] += from.color(k, i)[c] / float(3 * m_shots);
        m_plan.color.push_back(from.color(k, i)[c]);
        m_plan.guess.push_back(float(guess[c](i, k)));
        for (int j = 0; j <= i; ++j) m_plan.product.push_back(from.color(k, i)[c] * from.color(k, j)[c]);
      }
}

void MatteFit::fit(const PixelRun& in, const MatteRun& out) const {
  SWAPLIGHT_KERNEL(fitMatte)(m_plan, in, out);
}

void MatteFit::assess(const PixelRun& in, const MatteRun& inOut) const {
  SWAPLIGHT_KERNEL(assessMatte)(m_plan, in, inOut);
}

void Lambert::estimate(const PixelRun& in, const SolvedRun& out) const {
  MatteScratch scratch(m_fit.lights(), in.count);
  MatteRun run = scratch.run();
  if (!out.sigma) run.variance = run.shareVariance = nullptr;
  m_fit.fit(in, run);
  writeContributions(run, m_fit.lights(), in.count, out);
  writeQuality(run, m_fit.freedom(), in.count, out);
}

}  // namespace swaplight
