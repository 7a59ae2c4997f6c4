#include "core/solve/auto/auto_solve.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel.h"
#include "core/simd/simd.h"
#include "core/solve/auto/auto_scratch.h"
#include "core/solve/auto/neighbourhood.h"
#include "core/solve/auto/separated_lights.h"
#include "core/solve/auto/share_pooling.h"
#include "core/solve/auto/shrinkage.h"
#include "core/solve/calibration/edge_noise.h"
#include "core/solve/estimators/run_scratch.h"

namespace swaplight {
namespace {

/// Pooling took away part of the variance of the shares, which is nearly all of the contributions'.
SWAPLIGHT_SIMD(void, subtractPooledVariance,
               (const float* __restrict alone, const float* __restrict pooled, float* __restrict variance,
                int count),
               (alone, pooled, variance, count)) {
  for (int p = 0; p < count; ++p) {
    const float after = pooled[p] < alone[p] ? pooled[p] : alone[p];
    const float left = variance[p] - (alone[p] - after);
    variance[p] = left > after ? left : after;
  }
}

SWAPLIGHT_SIMD(void, multiply, (const float* __restrict factor, float* __restrict values, size_t count),
               (factor, values, count)) {
  for (size_t p = 0; p < count; ++p) values[p] *= factor[p];
}

SWAPLIGHT_SIMD(void, divide, (const float* __restrict factor, float* __restrict values, size_t count),
               (factor, values, count)) {
  for (size_t p = 0; p < count; ++p) values[p] /= factor[p];
}

/// Nothing between 0 and 1 has a variance above 1/4 (Popoviciu).
SWAPLIGHT_SIMD(void, limitVariance, (float* __restrict variance, int count), (variance, count)) {
  for (int p = 0; p < count; ++p) variance[p] /= 1 + 4 * variance[p];
}

/// The guide of pooling: the brightness of the set in steps that noise does not depend on.
SWAPLIGHT_SIMD(void, writeGuide,
               (const float* __restrict red, const float* __restrict green, const float* __restrict blue,
                float* __restrict guide, int count),
               (red, green, blue, guide, count)) {
  for (int p = 0; p < count; ++p) guide[p] = std::sqrt((red[p] + green[p] + blue[p]) * (1.0F / 3));
}

/// The shares and their variance, pooled with what is near, then with what is around that.
void poolTwice(const NoiseModel& noise, const PoolingTuning& tuning, const std::vector<ImageSpan>& shares,
               const AutoScratch& scratch) {
  const float step = guideStep(scratch.guide, noise, tuning);
  poolShares(
      shares, scratch.shareVariance, scratch.guide,
      {.step = 1, .rejectChi2 = tuning.nearChi2, .guideStep = step, .hiddenVariance = tuning.nearHidden},
      scratch.nearShares, scratch.nearVariance);
  poolShares(scratch.nearShares, scratch.nearVariance, scratch.guide,
             {.step = 2,
              .rejectChi2 = tuning.farChi2,
              .guideStep = step,
              .overlap = tuning.farOverlap,
              .hiddenVariance = tuning.farHidden,
              .clampAtZero = true},
             shares, scratch.shareVariance);
}

/// What a moved shot shows beyond its edge is made up: no evidence against the matte model.
void ignoreMisfitOutside(const std::vector<ShotShift>& shifts, ImageSpan misfit) {
  if (std::none_of(shifts.begin(), shifts.end(), worthMoving)) return;
  for (int y = 0; y < misfit.height; ++y)
    for (int x = 0; x < misfit.width; ++x)
      if (outsideAny(shifts, x, y, misfit.width, misfit.height)) misfit.row(0, y)[x] = 0;
}

}  // namespace

float solveAuto(const EstimatorContext& context, const ShotSignal& signal,
                const std::vector<ShotShift>& shifts, bool mayHaveMoved, const AutoTuning& tuning,
                SolvedSet& set, const Progress& progress) {
  Shrinkage shrinkage(context, signal, tuning.shrinkage);
  const int lights = context.lighting.lights;
  const int runs = int((signal.pixelCount() + kRun - 1) / kRun);
  const auto eachRun = [&](float from, float to, const auto& work) {
    std::atomic<int> done = 0;
    parallelRows(runs, 4, [&](int begin, int end) {
      std::vector<float> scratch;
      MatteScratch fit(lights, kRun);
      MatteRun run = fit.run();
      run.signedShares = true;
      for (int r = begin; r < end; ++r) {
        const size_t first = size_t(r) * kRun;
        PixelRun in;
        signal.run(first, int(std::min<size_t>(kRun, signal.pixelCount() - first)), true, scratch, in);
        // Shares are where they are kept (planes have room for whole lanes).
        for (int i = 0; i < lights; ++i) run.share[i] = set.beta.plane(i) + first;
        work(first, in, run);
      }
      progress.update(from + (to - from) * float(done += end - begin) / float(runs), "Separating lights");
    });
  };

  const AutoScratch waiting(set);
  const auto planeOf = [](const ImageSpan& span) { return span.row(0, 0); };
  float* misfit = planeOf(waiting.misfit);
  float* variance = planeOf(waiting.shareVariance);
  float* odds = planeOf(waiting.odds);
  float* guide = lights > 1 ? planeOf(waiting.guide) : nullptr;
  eachRun(0.1F, 0.5F, [&](size_t first, const PixelRun& in, MatteRun fit) {
    fit.misfit = misfit + first;
    fit.shareVariance = variance + first;
    shrinkage.matte().fit(in, fit);
    limitVariance(variance + first, in.count);
    if (guide)
      writeGuide(fit.reflectance[0], fit.reflectance[1], fit.reflectance[2], guide + first, in.count);
  });

  const int freedom = shrinkage.matte().freedom();
  const float seenShift =
      mayHaveMoved ? squaredEdgeShift(signal, context.noise, waiting.misfit, freedom, tuning.edges) : 0;
  // Between pixels nobody knows what an edge is like: shots that were moved agree no better than that.
  const float leastShift =
      std::any_of(shifts.begin(), shifts.end(), worthMoving) ? tuning.edges.resampled : 0.0F;
  const float squaredShift = std::max(seenShift, leastShift * leastShift);
  float* factor = squaredShift > 0 ? planeOf(waiting.edgeFactor) : nullptr;
  if (factor) {
    edgeNoiseFactor(signal, context.noise, squaredShift, waiting.edgeFactor);
    divide(factor, misfit, signal.pixelCount());
  }
  shrinkage.learn(signal, factor);
  ignoreMisfitOutside(shifts, waiting.misfit);
  localOdds(waiting.misfit, float(std::max(freedom, 1)), tuning.neighbourhood, waiting.odds);
  if (lights > 1) poolTwice(context.noise, tuning.pooling, planesOf(set.beta), waiting);

  eachRun(0.5F, 0.9F, [&](size_t first, const PixelRun& in, const MatteRun& fit) {
    shrinkage.matte().assess(in, fit);
    const float* noise = factor ? factor + first : nullptr;
    subtractPooledVariance(fit.shareVariance, variance + first, fit.variance, in.count);
    if (noise) multiply(noise, fit.variance, size_t(in.count));
    const SolvedRun out = runAt(set, first);
    shrinkage.finish(in, fit, {misfit + first, odds + first, noise}, out, odds + first);
    writeBeta(lights, in.count, out);
  });
  moveToFreeContributions(context, signal, separatedPart(context.lighting), set);
  return std::sqrt(seenShift);
}

}  // namespace swaplight
