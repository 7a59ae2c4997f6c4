#include "core/solve/calibration/noise_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/quantile.h"
#include "core/linear/decompositions.h"
#include "core/solve/estimators/matte_fit.h"
#include "core/solve/estimators/run_scratch.h"
#include "core/solve/model/pixel_sample.h"

namespace swaplight {
namespace {

constexpr int kBins = 10;

/// Least squares over x >= 0 for three unknowns: the best of all subsets whose solution is not negative.
Eigen::Vector3d nonNegative(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  double smallest = b.squaredNorm();
  for (int subset = 1; subset < 8; ++subset) {
    std::vector<int> columns;
    for (int j = 0; j < 3; ++j)
      if (subset >> j & 1) columns.push_back(j);
    const Eigen::MatrixXd part = a(Eigen::all, columns);
    const Eigen::VectorXd x = leastSquares(part, b);
    if (x.minCoeff() < 0) continue;
    const double left = (part * x - b).squaredNorm();
    if (left >= smallest) continue;
    smallest = left;
    best.setZero();
    for (size_t j = 0; j < columns.size(); ++j) best[columns[j]] = x[long(j)];
  }
  return best;
}

}  // namespace

double medianChiSquare(double freedom) {
  return freedom * std::pow(1 - 2 / (9 * freedom), 3);
}

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

  Eigen::MatrixXd powers(kBins, 3);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(kBins);
  for (size_t bin = 0; bin < kBins; ++bin) {
    // Relative errors of the variance count alike in all bins.
    const double y = brightness[bin];
    const double target =
        std::clamp(factor[bin], least, tuning.largestFactor) * context.noise.variance(float(y));
    powers.row(long(bin)) << 1 / target, y / target, y * y / target;
  }
  const Eigen::Vector3d x = nonNegative(powers, ones);
  NoiseModel model = context.noise;
  model.constant = std::max(float(x[0]), 1e-12F);
  model.linear = float(x[1]);
  model.square = std::max(float(x[2]), context.noise.square);
  return model;
}

}  // namespace swaplight
