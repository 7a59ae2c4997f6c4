#include "core/bench/timed_solver.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "core/base/parallel.h"
#include "core/simd/simd.h"
#include "core/solve/auto/auto_solve.h"
#include "core/solve/auto/local_evidence.h"
#include "core/solve/estimators/two_lights.h"

namespace swaplight {
namespace {

constexpr int kRowsOfRuns = 8;

constexpr int kStep = 64;  // pixels: all planes go on together, as they do in a solver

/// Every plane of `in` read and every plane of `out` written: the plainest stream with that many planes.
SWAPLIGHT_SIMD(void, streamRun, (const float* const* in, int reads, float* const* out, int writes, int count),
               (in, reads, out, writes, count)) {
  for (int begin = 0; begin < count; begin += kStep) {
    const int end = std::min(begin + kStep, count);
    for (int w = 0; w < writes; ++w) {
      const int first = w * reads / writes;
      const int last = std::max(first + 1, (w + 1) * reads / writes);
      const float* __restrict a = in[first];
      const float* __restrict b = in[last - 1];
      float* __restrict to = out[w];
      for (int p = begin; p < end; ++p) to[p] = a[p] + b[p];
    }
  }
}

/// Seconds of the best of calls that take `least` seconds together.
double bestSeconds(double least, const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  double best = INFINITY;
  double spent = 0;
  work();  // first touch
  do {
    const auto start = Clock::now();
    work();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    best = std::min(best, seconds);
    spent += seconds;
  } while (spent < least);
  return best;
}

void eachRun(size_t pixels, const std::function<void(size_t first, int count)>& work) {
  const int runs = int((pixels + kRun - 1) / kRun);
  parallelRows(runs, kRowsOfRuns, [&](int begin, int end) {
    for (int r = begin; r < end; ++r) {
      const size_t first = size_t(r) * kRun;
      work(first, int(std::min<size_t>(kRun, pixels - first)));
    }
  });
}

PixelRun inputAt(const BenchScene& scene, size_t first, int count) {
  PixelRun in;
  in.count = count;
  for (size_t k = 0; k < scene.pixels.shots.size(); ++k)
    for (int c = 0; c < 3; ++c) in.signal[k][c] = scene.pixels.shots[k].plane(c) + first;
  return in;
}

EstimatorContext contextOf(const BenchScene& scene) {
  return {lightingFromCapture(scene.capture), noiseModel(*scene.capture.noise, scene.pixels, 0)};
}

}  // namespace

SolvedSet roomFor(const BenchScene& scene) {
  SolvedSet set;
  set.capture = scene.capture;
  ImageSpec spec = scene.pixels.shots.front().spec();
  for (int i = 0; i < scene.capture.lightCount(); ++i) set.contributions.emplace_back(spec, 0);
  spec.channels.assign(size_t(scene.capture.lightCount()), "beta");
  set.beta = Image(spec, 0);
  spec.channels = {"residual", "sigma", "flags", "model"};
  set.quality = Image(spec, 0);
  return set;
}

double memorySpeed(const BenchScene& scene, SolvedSet& set, bool beta, double seconds) {
  const size_t pixels = scene.pixels.shots.front().pixelCount();
  const int lights = scene.capture.lightCount();
  const double best = bestSeconds(seconds, [&] {
    eachRun(pixels, [&](size_t first, int count) {
      const PixelRun in = inputAt(scene, first, count);
      SolvedRun out = runAt(set, first);
      std::vector<float*> planes(&out.contribution[0][0], &out.contribution[0][0] + 3 * lights);
      if (beta) planes.insert(planes.end(), out.beta, out.beta + lights);
      streamRun(&in.signal[0][0], 3 * scene.capture.shotCount(), planes.data(), int(planes.size()), count);
    });
  });
  return double(pixels) * 1e-6 / best;
}

double estimatorSpeed(const std::string& solver, const BenchScene& scene, SolvedSet& set, bool beta,
                      double seconds) {
  const size_t pixels = scene.pixels.shots.front().pixelCount();
  const EstimatorContext context = contextOf(scene);
  double best = 0;
  const EstimatorInfo& info = estimatorInfo(solver);
  if (info.model == Model::Auto) {
    best = bestSeconds(seconds, [&] {
      const ShotSignal signal(scene.pixels, context.lighting, context.noise,
                              std::vector<float>(size_t(context.lighting.shots), 1.0F));
      solveAuto(context, signal, {}, true, {}, set, {});
      followLocalEvidence(context, 0, signal, {}, set);
    });
  } else {
    const auto estimator = info.make(context);
    best = bestSeconds(seconds, [&] {
      eachRun(pixels, [&](size_t first, int count) {
        SolvedRun out = runAt(set, first);
        out.residual = out.sigma = nullptr;
        estimator->estimate(inputAt(scene, first, count), out);
        if (beta) writeBeta(context.lighting.lights, count, out);
      });
    });
  }
  return double(pixels) * 1e-6 / best;
}

double bruteForceSpeed(const BenchScene& scene, SolvedSet& set, double seconds) {
  const size_t pixels = std::min<size_t>(scene.pixels.shots.front().pixelCount(), size_t(32) * kRun);
  const auto estimator = estimatorInfo("brute-force").make(contextOf(scene));
  const double best = bestSeconds(seconds, [&] {
    const int runs = int(pixels / kRun);
    parallelEach(runs, [&](int r) {
      SolvedRun out = runAt(set, size_t(r) * kRun);
      out.residual = out.sigma = nullptr;
      estimator->estimate(inputAt(scene, size_t(r) * kRun, kRun), out);
    });
  });
  return double(pixels) * 1e-6 / best;
}

}  // namespace swaplight
