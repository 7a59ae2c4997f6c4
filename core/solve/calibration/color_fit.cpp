#include "core/solve/calibration/color_fit.h"

#include <algorithm>
#include <cmath>

#include "core/base/quantile.h"
#include "core/linear/decompositions.h"
#include "core/solve/calibration/color_equations.h"
#include "core/solve/estimators/run_scratch.h"
#include "core/solve/model/pixel_sample.h"

namespace swaplight {
namespace {

constexpr double kWork = 3e9;          // multiplications that a round may cost
constexpr double kMedianOfMean = 0.7;  // the median of chi-square over its mean, for few degrees of freedom

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

/// What is one unknown colour shares its unknowns.
ColorUnknowns unknownsOf(int entries, const std::vector<UnknownColor>& colors) {
  std::vector<int> first(size_t(entries), -1);
  for (const UnknownColor& color : colors)
    for (const int entry : color.entries) first[size_t(entry)] = color.entries.front();
  ColorUnknowns unknowns;
  for (int entry = 0; entry < entries; ++entry)
    for (int c = 0; c < 3; ++c) {
      const int shared = first[size_t(entry)];
      const bool known = shared >= 0 && shared != entry;
      unknowns.of.push_back(known ? unknowns.of[size_t(shared * 3 + c)] : unknowns.count++);
    }
  return unknowns;
}

/// The standard error of each unknown colour's worst channel, by the normal equations.
std::vector<double> errorsOf(const std::vector<UnknownColor>& colors, const ColorUnknowns& unknowns,
                             const Eigen::MatrixXd& normal) {
  std::vector<double> errors;
  if (colors.empty()) return errors;
  const Eigen::MatrixXd covariance = inverseOf(normal);
  for (const UnknownColor& color : colors) {
    double worst = 0;
    for (int c = 0; c < 3; ++c) {
      const int j = unknowns.of[size_t(color.entries.front() * 3 + c)];
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
  const ColorUnknowns unknown = unknownsOf(entries, options.unknown);
  const int unknowns = unknown.count;
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
    for (int c = 0; c < 3; ++c) precision[size_t(unknown.of[size_t(color.entries.front() * 3 + c)])] = 1;
  Eigen::VectorXd factor = Eigen::VectorXd::Ones(unknowns);  // of the colours over the given ones

  for (int round = 0; round < options.rounds; ++round) {
    current.lighting = result.lighting;
    const MatteFit matte(current);
    MatteScratch fit(n, in.count);
    matte.fit(in, fit.run());
    const ColorEquations equations(current, in, fit.run(), tuning.baseUncertainty, unknown);
    const auto relative = [&](const std::vector<double>& squared) {
      std::vector<double> errors;
      for (int p = 0; p < equations.pixels(); ++p)
        errors.push_back(squared[size_t(p)] * equations.scale(p) * equations.scale(p));
      return errors;
    };
    std::vector<double> robust(size_t(equations.pixels()), 1.0);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(unknowns);
    const std::vector<double> before = relative(equations.squaredLeft(step));
    std::vector<double> left;
    for (int pass = 0; pass < tuning.robustRounds; ++pass) {
      auto [h, g] = equations.sums(robust);
      for (int j = 0; j < unknowns; ++j) {
        h(j, j) += precision[size_t(j)] + 1e-9 * h.trace() / unknowns;
        g[j] -= precision[size_t(j)] * (factor[j] - 1);
      }
      step = solveSymmetric(h, g);
      if (pass + 1 == tuning.robustRounds && round + 1 == options.rounds)
        result.unknownError = errorsOf(options.unknown, unknown, h);
      left = equations.squaredLeft(step);
      const double typical = std::max(medianOf(left) / kMedianOfMean, 1e-12);
      for (size_t j = 0; j < left.size(); ++j) robust[j] = 1 / std::pow(1 + left[j] / typical, 2);
    }
    if (round == 0) {
      result.noise = std::sqrt(medianOf(equations.noise()));
      result.disagreement = std::sqrt(medianOf(before) / (freedom * kMedianOfMean));
      const double rest = medianOf(relative(left)) / (freedom * kMedianOfMean);
      result.systematic = std::sqrt(std::max(result.disagreement * result.disagreement - rest, 0.0));
    }
    for (int j = 0; j < unknowns; ++j) factor[j] *= std::clamp(1 + step[j], 0.5, 2.0);
    for (int j = 0; j < entries * 3; ++j)
      result.lighting.colors[size_t(j / 3)][j % 3] =
          context.lighting.colors[size_t(j / 3)][j % 3] * float(factor[unknown.of[size_t(j)]]);
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
