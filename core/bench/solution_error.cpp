#include "core/bench/solution_error.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/bench/matte_bound.h"
#include "core/measure/delta_e.h"
#include "core/relight/relight.h"

namespace swaplight {
namespace {

/// Variance of beta beyond which beta's own range says more than the data.
constexpr double kUsableBound = 0.01;

/// New lightings: all, the first alone, the last alone, a warm and cool mix, one light out and one pushed.
std::vector<std::vector<Rgb>> lightings(int lights) {
  std::vector<std::vector<Rgb>> all(5, std::vector<Rgb>(size_t(lights), Rgb(1)));
  for (int i = 0; i < lights; ++i) {
    all[1][size_t(i)] = Rgb(i == 0 ? 1.0F : 0.0F);
    all[2][size_t(i)] = Rgb(i == lights - 1 ? 1.0F : 0.0F);
    all[3][size_t(i)] = i % 2 == 0 ? Rgb(.9F, .6F, .3F) : Rgb(.3F, .5F, .9F);
    all[4][size_t(i)] = i == 0 ? Rgb(1.6F, 1.2F, 1.0F) : i == 1 ? Rgb(0) : Rgb(.4F, .9F, .5F);
  }
  return all;
}

void compareFrames(const SolvedSet& set, const SolvedSet& truth, SolutionError& row) {
  std::vector<float> differences;
  for (const std::vector<Rgb>& factors : lightings(truth.lightCount())) {
    const Image test = relight(set, factors, 0);
    const Image reference = relight(truth, factors, 0);
    std::vector<float> values;
    for (int c = 0; c < 3; ++c)
      values.insert(values.end(), reference.plane(c), reference.plane(c) + reference.pixelCount());
    const float bright = quantile(std::span(values), .995);
    ImageSpec spec = reference.spec();
    spec.channels = {"de2000"};
    Image difference(spec);
    deltaE2000(test.view(), reference.view(), 0.9F / std::max(bright, 1e-9F), difference.span());
    differences.insert(differences.end(), difference.plane(0), difference.plane(0) + difference.pixelCount());
  }
  double sum = 0;
  for (float d : differences) sum += d;
  row.deltaEMean = sum / double(differences.size());
  row.deltaE95 = quantile(std::span(differences), .95);
}

void compareContributions(const SolvedSet& set, const SolvedSet& truth, SolutionError& row) {
  double error = 0;
  double power = 0;
  for (size_t i = 0; i < truth.contributions.size(); ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < truth.beta.pixelCount(); ++p) {
        const double t = truth.contributions[i].plane(c)[p];
        const double d = set.contributions[i].plane(c)[p] - t;
        error += d * d;
        power += t * t;
      }
  row.relativeRmse = std::sqrt(error / std::max(power, 1e-300));
}

void compareBeta(const SolvedSet& set, const BoundedTruth& truth, SolutionError& row) {
  const int lights = truth.set.lightCount();
  double error = 0;
  double bound = 0;
  for (size_t p = 0; p < truth.betaBound.size(); ++p) {
    if (!(truth.betaBound[p] < kUsableBound)) continue;
    bound += truth.betaBound[p];
    for (int i = 0; i < lights; ++i)
      error += std::pow(double(set.beta.plane(i)[p]) - truth.set.beta.plane(i)[p], 2) / lights;
  }
  row.betaOverBound = bound > 0 ? std::sqrt(error / bound) : 0;
}

void compareSigma(const SolvedSet& set, const SolvedSet& truth, SolutionError& row) {
  size_t within = 0;
  size_t count = 0;
  for (size_t p = 0; p < truth.beta.pixelCount(); ++p) {
    double lit = 0;
    double solved = 0;
    for (int i = 0; i < truth.lightCount(); ++i)
      for (int c = 0; c < 3; ++c) {
        lit += truth.contributions[size_t(i)].plane(c)[p];
        solved += set.contributions[size_t(i)].plane(c)[p];
      }
    if (!(lit > 0)) continue;
    for (int i = 0; i < truth.lightCount(); ++i) {
      double error = 0;
      for (int c = 0; c < 3; ++c)
        error +=
            double(set.contributions[size_t(i)].plane(c)[p]) - truth.contributions[size_t(i)].plane(c)[p];
      within += std::abs(error) <= 2 * double(set.quality.plane(kSigma)[p]) * solved;
      ++count;
    }
  }
  row.withinTwoSigma = count ? double(within) / double(count) : 0;
}

size_t notFiniteIn(const Image& image) {
  size_t count = 0;
  for (int c = 0; c < image.channelCount(); ++c)
    count += size_t(std::count_if(image.plane(c), image.plane(c) + image.pixelCount(),
                                  [](float value) { return !std::isfinite(value); }));
  return count;
}

}  // namespace

BoundedTruth::BoundedTruth(SolvedSet truth, const LightingMatrix& lighting, const NoiseModel& noise,
                           float clip)
    : set(std::move(truth)), betaBound(set.beta.pixelCount()) {
  const int lights = set.lightCount();
  std::vector<double> contributionBound(betaBound.size());
  std::vector<double> power(betaBound.size());
  parallelRows(int(betaBound.size()), 4096, [&](int begin, int end) {
    std::vector<float> beta(static_cast<size_t>(lights));
    for (auto p = size_t(begin); p < size_t(end); ++p) {
      Rgb rho(0);
      for (int i = 0; i < lights; ++i) {
        beta[size_t(i)] = set.beta.plane(i)[p];
        for (int c = 0; c < 3; ++c) {
          const float t = set.contributions[size_t(i)].plane(c)[p];
          rho[c] += t;
          power[p] += double(t) * t;
        }
      }
      const MatteBound bound = matteBound(lighting, noise, clip, beta, rho);
      betaBound[p] = bound.beta;
      contributionBound[p] = std::min(bound.contribution, power[p]);
    }
  });
  double error = 0;
  double light = 0;
  for (size_t p = 0; p < power.size(); ++p) error += contributionBound[p], light += power[p];
  relativeBound = std::sqrt(error / std::max(light, 1e-300));
}

SolutionError compareSolution(const SolvedSet& set, const BoundedTruth& truth) {
  SolutionError error;
  compareContributions(set, truth.set, error);
  compareBeta(set, truth, error);
  compareFrames(set, truth.set, error);
  compareSigma(set, truth.set, error);
  for (const Image& contribution : set.contributions) error.notFinite += notFiniteIn(contribution);
  error.notFinite += notFiniteIn(set.beta) + notFiniteIn(set.quality);
  return error;
}

}  // namespace swaplight
