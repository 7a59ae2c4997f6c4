#include "core/solve/calibration/noise_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/quantile.h"
#include "core/solve/estimators/matte_fit.h"
#include "core/solve/estimators/run_scratch.h"
#include "core/solve/model/chi_square.h"
#include "core/solve/model/pixel_sample.h"
#include "core/solve/model/variance_fit.h"

namespace swaplight {
namespace {

constexpr int kBins = 10;

}  // namespace

NoiseModel calibratedNoise(const EstimatorContext& context, const ShotSignal& signal,
                           const NoiseCalibrationTuning& tuning) {
  const int lights = context.lighting.lights;
  const MatteFit matte(context);
  if (lights < 2 || matte.freedom() < 1) return context.noise;
  const PackedRun sample = pixelSample(signal, context.lighting.shots, size_t(tuning.sample));
  const PixelRun& in = sample.run();
  if (in.count < 100 * kBins) return context.noise;
  MatteScratch fit(lights, in.count);
  matte.fit(in, fit.run());
  std::vector<std::pair<float, int>> order;
  for (int p = 0; p < in.count; ++p) {
    float sum = 0;
    for (int k = 0; k < context.lighting.shots; ++k)
      for (int c = 0; c < 3; ++c) sum += in.signal[k][c][p];
    order.emplace_back(sum / float(3 * context.lighting.shots), p);
  }
  std::sort(order.begin(), order.end());

  std::array<double, kBins> brightness{}, factor{};
  for (size_t bin = 0; bin < kBins; ++bin) {
    const size_t first = order.size() * bin / kBins;
    const size_t last = order.size() * (bin + 1) / kBins;
    std::vector<float> misfit;
    for (size_t j = first; j < last; ++j) {
      misfit.push_back(fit.run().misfit[order[j].second]);
      brightness[bin] += std::max(order[j].first, 0.0F) / float(last - first);
    }
    factor[bin] = median(std::span(misfit)) / medianChiSquare(matte.freedom());
  }
  // Less than expected is believed only where all bins say so.
  const double most = *std::max_element(factor.begin(), factor.end());
  const double least = most < tuning.nothingFlat ? tuning.smallestFactor : 1;

  std::vector<VariancePoint> points;
  for (size_t bin = 0; bin < kBins; ++bin) {
    const double y = brightness[bin];
    const double target =
        std::clamp(factor[bin], least, tuning.largestFactor) * context.noise.variance(float(y));
    points.push_back({y, target});
  }
  const std::array<double, 3> x = fitVariance(points);
  NoiseModel model = context.noise;
  model.constant = std::max(float(x[0]), 1e-12F);
  model.linear = float(x[1]);
  model.square = std::max(float(x[2]), context.noise.square);
  return model;
}

}  // namespace swaplight
