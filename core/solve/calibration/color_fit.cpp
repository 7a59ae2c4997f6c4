#include "core/solve/calibration/color_fit.h"

#include <algorithm>
#include <cmath>

#include "core/base/quantile.h"
#include "core/linear/decompositions.h"
#include "core/solve/estimators/run_scratch.h"
#include "core/solve/model/pixel_sample.h"

namespace swaplight {
namespace {

constexpr double kWork = 3e9;          // multiplications that a round may cost
constexpr double kMedianOfMean = 0.7;  // the median of chi-square over its mean, for few degrees of freedom

/// One pixel's weighted residual and how it depends on the colours, its own unknowns projected out.
struct PixelEquation {
  Eigen::VectorXd residual;
  Eigen::MatrixXd slope;
  double scale;  ///< what turns a weighted residual into one relative to the signal
  double noise;  ///< the variance that noise explains, relative to the signal squared
};

/// A sample of bright, usable pixels.
PackedRun brightSample(const ShotSignal& signal, int shots, size_t count, double share) {
  const PackedRun all = pixelSample(signal, shots, size_t(double(count) / share));
  std::vector<std::pair<float, int>> order;
  for (int p = 0; p < all.run().count; ++p) {
    float sum = 0;
    for (int k = 0; k < shots; ++k)
      for (int c = 0; c < 3; ++c) sum += all.run().signal[k][c][p];
    order.emplace_back(sum, p);
  }
  const size_t keep = size_t(share * double(order.size()));
  std::nth_element(order.begin(), order.begin() + long(keep), order.end(), std::greater<>());
  PackedRun bright(shots, std::max<size_t>(keep, 1));
  for (size_t j = 0; j < keep; ++j) bright.add(all.run(), order[j].second);
  return bright;
}

PixelEquation equationOf(const EstimatorContext& context, const PixelRun& in, const MatteRun& fit, int p,
                         double baseUncertainty) {
  const LightingMatrix& lighting = context.lighting;
  const int n = lighting.lights;
  const int values = 3 * lighting.shots;
  Eigen::VectorXd residual(values);
  Eigen::MatrixXd own = Eigen::MatrixXd::Zero(values, 3 + n);
  Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(values, values * n);
  double power = 0;
  double weights = 0;
  double noise = 0;
  for (int k = 0; k < lighting.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      const int row = k * 3 + c;
      const double rho = fit.reflectance[c][p];
      double g = 0;
      for (int i = 0; i < n; ++i) g += double(lighting.color(k, i)[c]) * fit.share[i][p];
      const double variance = context.noise.variance(float(g * rho));
      const double w = 1 / std::sqrt(variance + std::pow(baseUncertainty * g * rho, 2));
      noise += variance;
      residual[row] = w * (in.signal[k][c][p] - g * rho);
      own(row, c) = w * g;
      for (int i = 0; i < n; ++i) {
        const double t = double(lighting.color(k, i)[c]) * fit.share[i][p] * rho;
        if (fit.share[i][p] > 1e-4F) own(row, 3 + i) = w * double(lighting.color(k, i)[c]) * rho;
        slope(row, (k * n + i) * 3 + c) = w * t;
      }
      power += g * rho * g * rho;
      weights += w * w;
    }
  const Eigen::MatrixXd gram = own.transpose() * own;
  const Eigen::MatrixXd inverse =
      inverseOf(gram + (1e-9 * gram.trace() + 1e-30) * Eigen::MatrixXd::Identity(3 + n, 3 + n));
  const Eigen::MatrixXd project = own * inverse * own.transpose();
  PixelEquation equation;
  equation.residual = residual - project * residual;
  equation.slope = slope - project * slope;
  equation.scale = 1 / std::sqrt(std::max(power / values, 1e-30) * weights / values);
  equation.noise = noise / std::max(power, 1e-30);
  return equation;
}

double medianOf(std::vector<double> values) {
  return values.empty() ? 0 : median(std::span(values));
}

}  // namespace

ColorFit fitColors(const EstimatorContext& context, const ShotSignal& signal, const ColorFitOptions& options,
                   const ColorFitTuning& tuning) {
  const int n = context.lighting.lights;
  const int values = 3 * context.lighting.shots;
  const int unknowns = values * n;
  const double freedom = std::max(values - n - 2, 1);
  ColorFit result;
  result.lighting = context.lighting;
  if (n < 2 || values <= n + 2) return result;
  const size_t count =
      std::clamp(size_t(kWork / (double(values) * unknowns * unknowns)), size_t(300), size_t(tuning.sample));
  const PackedRun sample = brightSample(signal, context.lighting.shots, count, tuning.brightShare);
  const PixelRun& in = sample.run();
  if (in.count < 50) return result;

  EstimatorContext current = context;
  std::vector<double> precision(size_t(unknowns), 1 / (options.priorSigma * options.priorSigma));
  for (int entry : options.unknown)
    for (int c = 0; c < 3; ++c) precision[size_t(entry) * 3 + size_t(c)] = 1;
  Eigen::VectorXd given(unknowns);
  const auto colorAt = [&](LightingMatrix& lighting, int index) -> float& {
    return lighting.color(index / 3 / n, index / 3 % n)[index % 3];
  };
  for (int j = 0; j < unknowns; ++j) given[j] = colorAt(result.lighting, j);

  for (int round = 0; round < options.rounds; ++round) {
    current.lighting = result.lighting;
    const MatteFit matte(current);
    MatteScratch fit(n, in.count);
    matte.fit(in, fit.run());
    std::vector<PixelEquation> equations;
    equations.reserve(size_t(in.count));
    for (int p = 0; p < in.count; ++p)
      equations.push_back(equationOf(current, in, fit.run(), p, tuning.baseUncertainty));
    std::vector<double> robust(equations.size(), 1.0);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(unknowns);
    std::vector<double> before, after, noise;
    for (int pass = 0; pass < tuning.robustRounds; ++pass) {
      Eigen::MatrixXd h = Eigen::MatrixXd::Zero(unknowns, unknowns);
      Eigen::VectorXd g = Eigen::VectorXd::Zero(unknowns);
      for (size_t j = 0; j < equations.size(); ++j) {
        h.selfadjointView<Eigen::Lower>().rankUpdate(equations[j].slope.transpose(), robust[j]);
        g += robust[j] * (equations[j].slope.transpose() * equations[j].residual);
      }
      h = h.selfadjointView<Eigen::Lower>();
      for (int j = 0; j < unknowns; ++j) {
        const double now = given[j] > 0 ? colorAt(result.lighting, j) / given[j] - 1 : 0;
        h(j, j) += precision[size_t(j)] + 1e-9 * h.trace() / unknowns;
        g[j] -= precision[size_t(j)] * now;
      }
      step = solveSymmetric(h, g);
      before.clear(), after.clear();
      std::vector<double> left;
      for (const PixelEquation& e : equations) {
        left.push_back((e.residual - e.slope * step).squaredNorm());
        before.push_back(e.residual.squaredNorm() * e.scale * e.scale);
        after.push_back(left.back() * e.scale * e.scale);
      }
      const double typical = std::max(medianOf(left) / kMedianOfMean, 1e-12);
      for (size_t j = 0; j < left.size(); ++j) robust[j] = 1 / std::pow(1 + left[j] / typical, 2);
    }
    for (const PixelEquation& e : equations) noise.push_back(e.noise);
    if (round == 0) {
      result.noise = std::sqrt(medianOf(noise));
      result.disagreement = std::sqrt(medianOf(before) / (freedom * kMedianOfMean));
      const double rest = medianOf(after) / (freedom * kMedianOfMean);
      result.systematic = std::sqrt(std::max(result.disagreement * result.disagreement - rest, 0.0));
    }
    for (int j = 0; j < unknowns; ++j) {
      float& color = colorAt(result.lighting, j);
      color *= float(std::clamp(1 + step[j], 0.5, 2.0));
    }
  }
  double change = 0;
  for (int j = 0; j < unknowns; ++j)
    if (given[j] > 0) change += std::pow(colorAt(result.lighting, j) / given[j] - 1, 2);
  result.change = std::sqrt(change / unknowns);
  return result;
}

float colorUncertaintyOf(const ColorFit& fit, const ColorFitTuning& tuning) {
  const double floor = tuning.systematicFloor;
  return float(tuning.absorbed * std::sqrt(std::max(fit.systematic * fit.systematic - floor * floor, 0.0)));
}

float usualColorUncertainty(const SensorNoise& estimated, const ColorFitTuning& tuning) {
  constexpr double kMidTone = 0.2;
  const double error = std::sqrt(estimated.read * estimated.read + kMidTone / estimated.fullWell);
  return error > tuning.noisyError ? tuning.noisyUncertainty : 0.0F;
}

}  // namespace swaplight
