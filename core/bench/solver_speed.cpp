#include "core/bench/solver_speed.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "core/base/parallel.h"
#include "core/bench/bench_scene.h"
#include "core/simd/simd.h"
#include "core/solve/auto/auto_solve.h"
#include "core/solve/auto/local_evidence.h"
#include "core/solve/estimators/two_lights.h"

namespace swaplight {
namespace {

constexpr int kRowsOfRuns = 8;

/// out = sum of in, for `writes` planes out: the plainest stream with that many planes.
SWAPLIGHT_SIMD(void, streamRun, (const float* const* in, int reads, float* const* out, int writes, int count),
               (in, reads, out, writes, count)) {
  for (int w = 0; w < writes; ++w) {
    const int first = w * reads / writes;
    const int last = std::max(first + 1, (w + 1) * reads / writes);
    const float* __restrict a = in[first % reads];
    float* __restrict to = out[w];
    if (last - first == 1) {
      for (int p = 0; p < count; ++p) to[p] = a[p] * 1.5F;
    } else {
      const float* __restrict b = in[(first + 1) % reads];
      for (int p = 0; p < count; ++p) to[p] = a[p] + b[p];
    }
  }
}

/// Seconds of the best of several calls that take `least` seconds together.
double bestSeconds(double least, const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  double best = INFINITY;
  double spent = 0;
  work();  // first touch
  while (spent < least) {
    const auto start = Clock::now();
    work();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    best = std::min(best, seconds);
    spent += seconds;
  }
  return best;
}

/// Room for an answer, used again by every solver.
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

/// Megapixels a second of the memory's limit: every plane of the shots read, every plane of the answer
/// written.
double streamLimit(const BenchScene& scene, SolvedSet& set, bool beta, double seconds) {
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

EstimatorContext contextOf(const BenchScene& scene) {
  return {lightingFromCapture(scene.capture), noiseModel(*scene.capture.noise, scene.pixels, 0)};
}

double solverSpeed(const std::string& solver, const BenchScene& scene, SolvedSet& set, bool beta,
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

/// The literal search is timed on a part of the picture: it needs a minute for all of it.
double bruteForceSpeed(const BenchScene& scene, SolvedSet& set, double seconds) {
  const size_t pixels = std::min<size_t>(scene.pixels.shots.front().pixelCount(), size_t(32) * kRun);
  const auto estimator = estimatorInfo("brute-force").make(contextOf(scene));
  const double best = bestSeconds(seconds, [&] {
    const int runs = int(pixels / kRun);
    parallelRows(runs, 1, [&](int begin, int end) {
      for (int r = begin; r < end; ++r) {
        SolvedRun out = runAt(set, size_t(r) * kRun);
        out.residual = out.sigma = nullptr;
        estimator->estimate(inputAt(scene, size_t(r) * kRun, kRun), out);
      }
    });
  });
  return double(pixels) * 1e-6 / best;
}

}  // namespace

std::vector<SolverSpeed> measureSolverSpeed(const SolverSpeedOptions& options, const Progress& progress) {
  std::vector<SolverSpeed> rows;
  const int before = threadCount();
  const double steps = double(options.lights.size() * options.threads.size());
  double done = 0;
  for (int lights : options.lights) {
    const BenchScene matte = makeBenchScene(options.width, options.height, lights, 0.02F);
    const BenchScene lit = makeLitScene(options.width, options.height, lights);
    const BenchScene glossy = makeBenchScene(options.width, options.height, lights, 0.15F);
    SolvedSet set = roomFor(matte);
    for (int threads : options.threads) {
      progress.update(float(done++ / steps), fmt::format("{} lights, {} threads", lights, threads));
      setThreads(threads);
      const double brute = lights == 2 ? bruteForceSpeed(matte, set, options.seconds) : 0;
      if (brute > 0) rows.push_back({"brute-force", lights, threads, brute, 0, 1});
      const auto add = [&](const std::string& solver, const std::string& name, const BenchScene& scene,
                           bool beta) {
        const double limit = streamLimit(scene, set, beta, options.seconds);
        const double speed = solverSpeed(solver, scene, set, beta, options.seconds);
        rows.push_back({name, lights, threads, speed, limit, brute > 0 ? speed / brute : 0});
      };
      if (lights == 2) add("closed-form", "closed-form", matte, false);
      add("demultiplex", "demultiplex + beta", matte, true);
      add("demultiplex", "demultiplex + beta, nothing negative", lit, true);
      add("nnls", "nnls + beta, nothing negative", lit, true);
      add("nnls", "nnls + beta", matte, true);
      add("maximum-likelihood", "maximum-likelihood", matte, true);
      add("auto", "auto, mostly matte", matte, true);
      add("auto", "auto, glossy", glossy, true);
    }
  }
  setThreads(before);
  return rows;
}

}  // namespace swaplight
