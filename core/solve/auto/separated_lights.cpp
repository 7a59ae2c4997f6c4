#include "core/solve/auto/separated_lights.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/linear/decompositions.h"
#include "core/simd/simd.h"
#include "core/solve/estimators/demultiplex.h"
#include "core/solve/model/solved_planes.h"

namespace swaplight {
namespace {

/// Variance inflation beyond 1 from which on a pixel's evidence alone decides.
constexpr double kInflation = .1;
constexpr float kDamage = 1e12F;  // pictures lie around 1 (signal_scale.h)

SWAPLIGHT_SIMD(void, mixIn,
               (const float* __restrict other, const float* __restrict part, float* __restrict values,
                int count),
               (other, part, values, count)) {
  for (int p = 0; p < count; ++p) values[p] += part[p] * (other[p] - values[p]);
}

SWAPLIGHT_SIMD(void, raiseTo, (const float* __restrict least, float* __restrict values, int count),
               (least, values, count)) {
  for (int p = 0; p < count; ++p) values[p] = values[p] > least[p] ? values[p] : least[p];
}

/// Whether every value of a pixel is one: below zero is noise around no light, and what is clipped is clipped
/// in the only photograph of its light.
bool isWhole(const ShotSignal& signal, size_t pixel) {
  for (const Image& shot : signal.pixels().shots)
    for (int c = 0; c < 3; ++c)
      if (!(std::abs(shot.plane(c)[pixel]) < kDamage)) return false;
  return true;
}

}  // namespace

float separatedPart(const LightingMatrix& lighting) {
  if (lighting.shots < lighting.lights || lighting.lights < 2) return 0;
  double worst = 1;
  for (int c = 0; c < 3; ++c) {
    const Eigen::MatrixXd colors = lighting.matrix(c);
    const Eigen::MatrixXd gram = colors.transpose() * colors;
    const Eigen::VectorXd inflation = inverseOf(gram).diagonal().cwiseProduct(gram.diagonal());
    if (!inflation.allFinite() || inflation.minCoeff() < .99) return 0;  // a singular matrix, or nearly
    worst = std::max(worst, inflation.maxCoeff());
  }
  return float(std::clamp(1 - (worst - 1) / kInflation, 0.0, 1.0));
}

void moveToFreeContributions(const EstimatorContext& context, const ShotSignal& signal, float part,
                             SolvedSet& set) {
  if (part <= 0) return;
  const int lights = context.lighting.lights;
  const Demultiplex free(context, Demultiplex::Bound::LeastSquares);
  const int runs = int((signal.pixelCount() + kRun - 1) / kRun);
  parallelRows(runs, 4, [&](int begin, int end) {
    std::vector<float> scratch;
    std::vector<float> parts(kRun);
    const SolvedPlanes room(lights, kRun);
    const SolvedRun& from = room.run();
    for (int r = begin; r < end; ++r) {
      const size_t first = size_t(r) * kRun;
      PixelRun in;
      signal.run(first, int(std::min<size_t>(kRun, signal.pixelCount() - first)), false, scratch, in);
      free.estimate(in, from);
      std::fill_n(parts.data(), in.count, part);
      if (signal.flagged(first, in.count))
        for (int p = 0; p < in.count; ++p)
          if (signal.flags()[first + size_t(p)] && !isWhole(signal, first + size_t(p))) parts[size_t(p)] = 0;
      const SolvedRun to = runAt(set, first);
      for (int i = 0; i < lights; ++i)
        for (int c = 0; c < 3; ++c)
          mixIn(from.contribution[i][c], parts.data(), to.contribution[i][c], in.count);
      mixIn(from.residual, parts.data(), to.residual, in.count);
      mixIn(from.sigma, parts.data(), to.sigma, in.count);
      raiseTo(parts.data(), set.quality.plane(kModel) + first, in.count);
      writeBeta(lights, in.count, to);
    }
  });
}

}  // namespace swaplight
