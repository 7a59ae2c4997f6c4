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

/// `unknowns`: which unknown each entry's channel is, of `count`.
PixelEquation equationOf(const EstimatorContext& context, const PixelRun& in, const MatteRun& fit, int p,
                         double baseUncertainty, const std::vector<int>& unknowns, int count) {
  const LightingMatrix& lighting = context.lighting;
  const int n = lighting.lights;
  const int values = 3 * lighting.shots;
  Eigen::VectorXd residual(values);
  Eigen::MatrixXd own = Eigen::MatrixXd::Zero(values, 3 + n);
  Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(values, count);
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
        slope(row, unknowns[size_t(k * n + i) * 3 + size_t(c)]) += w * t;
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

/// Which of the fit's unknowns each entry's channel is: what is one unknown colour shares them.
std::vector<int> unknownsOf(int entries, const std::vector<UnknownColor>& colors) {
  std::vector<int> first(size_t(entries), -1);
  for (const UnknownColor& color : colors)
    for (const int entry : color.entries) first[size_t(entry)] = color.entries.front();
  std::vector<int> unknowns;
  int next = 0;
  for (int entry = 0; entry < entries; ++entry)
    for (int c = 0; c < 3; ++c) {
      const int shared = first[size_t(entry)];
      unknowns.push_back(shared >= 0 && shared != entry ? unknowns[size_t(shared * 3 + c)] : next++);
    }
  return unknowns;
}

/// The standard error of each unknown colour's worst channel, by the normal equations.
std::vector<double> errorsOf(const std::vector<UnknownColor>& colors, const std::vector<int>& unknowns,
                             const Eigen::MatrixXd& normal) {
  std::vector<double> errors;
  if (colors.empty()) return errors;
  const Eigen::MatrixXd covariance = inverseOf(normal);
  for (const UnknownColor& color : colors) {
    double worst = 0;
    for (int c = 0; c < 3; ++c) {
      const int j = unknowns[size_t(color.entries.front() * 3 + c)];
      worst = std::max(worst, std::sqrt(std::max(covariance(j, j), 0.0)));
    }
    errors.push_back(worst);
  }
  return errors;
}

double medianOf(std::vector<double> values) {
  return values.empty() ? 0 : median(std::span(values));
}

}  // namespace

ColorFit fitColors(const EstimatorContext& context, const ShotSignal& signal, const ColorFitOptions& options,
                   const ColorFitTuning& tuning) {
  const int n = context.lighting.lights;
  const int values = 3 * context.lighting.shots;
  const int entries = context.lighting.shots * n;
  const std::vector<int> unknown = unknownsOf(entries, options.unknown);
  const int unknowns = 1 + *std::max_element(unknown.begin(), unknown.end());
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
  for (const UnknownColor& color : options.unknown)
    for (int c = 0; c < 3; ++c) precision[size_t(unknown[size_t(color.entries.front() * 3 + c)])] = 1;
  Eigen::VectorXd factor = Eigen::VectorXd::Ones(unknowns);  // of the colours over the given ones

  for (int round = 0; round < options.rounds; ++round) {
    current.lighting = result.lighting;
    const MatteFit matte(current);
    MatteScratch fit(n, in.count);
    matte.fit(in, fit.run());
    std::vector<PixelEquation> equations;
    equations.reserve(size_t(in.count));
    for (int p = 0; p < in.count; ++p)
      equations.push_back(equationOf(current, in, fit.run(), p, tuning.baseUncertainty, unknown, unknowns));
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
        h(j, j) += precision[size_t(j)] + 1e-9 * h.trace() / unknowns;
        g[j] -= precision[size_t(j)] * (factor[j] - 1);
      }
      step = solveSymmetric(h, g);
      if (pass + 1 == tuning.robustRounds && round + 1 == options.rounds)
        result.unknownError = errorsOf(options.unknown, unknown, h);
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
    for (int j = 0; j < unknowns; ++j) factor[j] *= std::clamp(1 + step[j], 0.5, 2.0);
    for (int j = 0; j < entries * 3; ++j)
      result.lighting.colors[size_t(j / 3)][j % 3] =
          context.lighting.colors[size_t(j / 3)][j % 3] * float(factor[unknown[size_t(j)]]);
  }
  result.change = std::sqrt((factor.array() - 1).square().mean());
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
