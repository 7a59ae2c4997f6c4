#include "core/bench/solver_error.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/bench/bench_scene.h"
#include "core/bench/beta_bound.h"
#include "core/error.h"
#include "core/image/image_io.h"
#include "core/image/rgb_image.h"
#include "core/measure/delta_e.h"
#include "core/relight/relight.h"
#include "core/solve/estimator.h"
#include "core/solve/solve.h"

namespace swaplight {
namespace {

constexpr double kUsableBound =
    0.01;  // variance of beta beyond which beta's own range says more than the data

SolvedSet truthOf(const Capture& capture) {
  SolvedSet truth;
  truth.capture = capture;
  for (const Light& light : capture.lights) {
    const auto path = capture.truth.find(light.name);
    if (path == capture.truth.end())
      throw InputError("{}: has no truth for light {}; the benchmark needs a capture with \"truth\"",
                       capture.file.string(), light.name);
    truth.contributions.push_back(rgbImage(readImage(capture.folder / path->second).image, path->second));
  }
  updateBeta(truth);
  return truth;
}

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

void compareFrames(const SolvedSet& set, const SolvedSet& truth, SolverError& row) {
  std::vector<float> differences;
  for (const std::vector<Rgb>& factors : lightings(truth.lightCount())) {
    const Image test = relight(set, factors, 0);
    const Image reference = relight(truth, factors, 0);
    std::vector<float> values;
    for (int c = 0; c < 3; ++c)
      values.insert(values.end(), reference.plane(c), reference.plane(c) + reference.pixelCount());
    const size_t bright = values.size() * 995 / 1000;
    std::nth_element(values.begin(), values.begin() + long(bright), values.end());
    ImageSpec spec = reference.spec();
    spec.channels = {"de2000"};
    Image difference(spec);
    deltaE2000(test.view(), reference.view(), 0.9F / std::max(values[bright], 1e-9F), difference.span());
    differences.insert(differences.end(), difference.plane(0), difference.plane(0) + difference.pixelCount());
  }
  double sum = 0;
  for (float d : differences) sum += d;
  row.deltaEMean = sum / double(differences.size());
  const size_t high = differences.size() * 95 / 100;
  std::nth_element(differences.begin(), differences.begin() + long(high), differences.end());
  row.deltaE95 = differences[high];
}

void compareContributions(const SolvedSet& set, const SolvedSet& truth, SolverError& row) {
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

void compareBeta(const SolvedSet& set, const SolvedSet& truth, const LightPlan& plan, const NoiseModel& noise,
                 SolverError& row) {
  const int lights = truth.lightCount();
  double error = 0;
  double bound = 0;
  std::vector<float> beta(static_cast<size_t>(lights));
  // A sample: the bound needs a matrix inverse a pixel.
  const size_t step = std::max<size_t>(1, truth.beta.pixelCount() / 20000);
  for (size_t p = 0; p < truth.beta.pixelCount(); p += step) {
    Rgb rho(0);
    for (int i = 0; i < lights; ++i) {
      beta[size_t(i)] = truth.beta.plane(i)[p];
      for (int c = 0; c < 3; ++c) rho[c] += truth.contributions[size_t(i)].plane(c)[p];
    }
    const double smallest = betaBound(plan, noise, beta, rho);
    if (!(smallest < kUsableBound)) continue;
    bound += smallest;
    for (int i = 0; i < lights; ++i)
      error += std::pow(double(set.beta.plane(i)[p]) - beta[size_t(i)], 2) / lights;
  }
  row.betaOverBound = bound > 0 ? std::sqrt(error / bound) : 0;
}

}  // namespace

std::vector<SolverError> measureSolverError(const std::filesystem::path& file, unsigned seed,
                                            const Progress& progress) {
  Capture capture = readCapture(file);
  const SolvedSet truth = truthOf(capture);
  if (!capture.noise) capture.noise = SensorNoise{.002, 20000};
  const CapturePixels pixels = photograph(capture, truth.contributions, seed);
  const LightPlan plan = planFromCapture(capture);
  const NoiseModel noise = noiseModel(*capture.noise, pixels, 0);
  std::vector<SolverError> rows;
  for (const EstimatorInfo& info : estimators()) {
    const bool twoOnly = info.name == "brute-force" || info.name == "published" || info.name == "closed-form";
    if (twoOnly && (plan.lights != 2 || plan.shots != 2)) continue;
    progress.update(float(rows.size()) / float(estimators().size()), std::string(info.name));
    SolveOptions options;
    options.solver = std::string(info.name);
    const auto start = std::chrono::steady_clock::now();
    const SolvedSet set = solve(capture, pixels, options);
    SolverError row;
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    row.capture = capture.name;
    row.solver = std::string(info.name);
    compareContributions(set, truth, row);
    compareBeta(set, truth, plan, noise, row);
    compareFrames(set, truth, row);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace swaplight
