#include "core/solve/calibration/residual_noise.h"

#include <algorithm>
#include <cmath>

#include "core/base/quantile.h"
#include "core/solve/calibration/block_misfit.h"
#include "core/solve/estimators/matte_fit.h"
#include "core/solve/model/chi_square.h"
#include "core/solve/model/variance_fit.h"

namespace swaplight {
namespace {

constexpr double kQuietNormal = -0.8416;  // the 20 % quantile of a normal variable: of the quietest fifth

/// The variance of the quietest fifth of blocks [first, last), over the noise model's.
template <typename Value>
double quietFactor(const std::vector<BlockMisfit>& blocks, size_t first, size_t last, int degrees,
                   const Value& value) {
  std::vector<float> values;
  double freedom = 0;
  for (size_t j = first; j < last; ++j) {
    values.push_back(value(blocks[j]));
    freedom += double(blocks[j].freedom) / double(last - first);
  }
  return quantile(std::span(values), .2) / chiSquareQuantile(degrees * freedom, kQuietNormal);
}

}  // namespace

NoiseModel residualNoise(const EstimatorContext& context, const NoiseModel& least, const ShotSignal& signal,
                         const ResidualNoiseTuning& tuning) {
  const MatteFit matte(context);
  if (context.lighting.lights < 2 || matte.freedom() < 1) return context.noise;
  std::vector<BlockMisfit> blocks =
      blockMisfits(matte, context.lighting, context.noise, signal, tuning.blocks);
  const int bins = std::min(tuning.mostBins, int(blocks.size()) / std::max(tuning.fewest, 1));
  if (bins < 1) return context.noise;
  std::sort(blocks.begin(), blocks.end(),
            [](const BlockMisfit& a, const BlockMisfit& b) { return a.brightness < b.brightness; });

  std::vector<VariancePoint> points;
  for (int bin = 0; bin < bins; ++bin) {
    const size_t first = blocks.size() * size_t(bin) / size_t(bins);
    const size_t last = blocks.size() * size_t(bin + 1) / size_t(bins);
    double y = 0;
    for (size_t j = first; j < last; ++j) y += std::max(blocks[j].brightness, 0.0F) / double(last - first);
    const double fine = quietFactor(blocks, first, last, BlockMisfit::kFineDegrees,
                                    [](const BlockMisfit& block) { return block.fine; });
    const double coarse = quietFactor(blocks, first, last, BlockMisfit::kCoarseDegrees,
                                      [](const BlockMisfit& block) { return block.coarse; });
    // Neither texture nor a wrong model makes the smaller of the two estimates too small.
    const double factor =
        std::min(fine, 1.0) * std::clamp(coarse / std::max(fine, 1e-12), 1.0, tuning.mostCorrelated);
    const double target =
        std::max(factor * context.noise.variance(float(y)), double(least.variance(float(y))));
    points.push_back({y, target});
  }
  const auto [constant, linear] = varianceBelow(points);
  NoiseModel model = context.noise;
  model.constant = std::max(float(constant), least.constant);
  model.linear = std::max(float(linear), least.linear);
  return model;
}

NoiseModel withModelError(const NoiseModel& own, const NoiseModel& calibrated, float part) {
  const auto between = [&](float least, float most) { return least + part * std::max(most - least, 0.0F); };
  return {between(own.constant, calibrated.constant), between(own.linear, calibrated.linear),
          between(own.square, calibrated.square)};
}

NoiseModel codingNoise(const CapturePixels& photographs) {
  constexpr double kNoPhotonNoise = 1e12;  // full well
  return noiseModel({0, kNoPhotonNoise}, photographs, 0);
}

}  // namespace swaplight
