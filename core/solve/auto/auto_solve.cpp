#include "core/solve/auto/auto_solve.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel.h"
#include "core/simd/simd.h"
#include "core/solve/auto/neighbourhood.h"
#include "core/solve/auto/share_pooling.h"
#include "core/solve/auto/shrinkage.h"
#include "core/solve/calibration/edge_noise.h"
#include "core/solve/estimators/run_scratch.h"

namespace swaplight {
namespace {

/// Pooling took away part of the variance of the shares, which is nearly all of the contributions'.
SWAPLIGHT_SIMD(void, takeAway,
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

/// The shares in `beta`, their variance in `quality.sigma`, the guide in the second light's contribution:
/// pooled with what is near, then with what is around that. In between they wait in planes of the
/// contributions.
void poolTwice(const NoiseModel& noise, SolvedSet& set) {
  const ImageSpan variance = set.quality.span().channelRange(kSigma, 1);
  const ImageSpan left = set.contributions[0].span().channelRange(1, 1);
  const ImageSpan guide = set.contributions[1].span().channelRange(1, 1);
  const std::vector<ImageSpan> shares = planesOf(set.beta);
  std::vector<ImageSpan> near;
  for (Image& contribution : set.contributions) near.push_back(contribution.span().channelRange(0, 1));
  const float step = guideStep(guide, noise);
  poolShares(shares, variance, guide, {.step = 1, .cut = 9, .guideStep = step}, near, left);
  poolShares(near, left, guide,
             {.step = 2, .cut = 4, .guideStep = step, .overlap = 3.7F, .doubt = .4F, .cutAtZero = true},
             shares, variance);
}

/// What a moved shot shows beyond its edge is made up: no evidence against the matte model.
void trustOutside(const std::vector<ShotShift>& shifts, ImageSpan misfit) {
  if (std::none_of(shifts.begin(), shifts.end(), worthMoving)) return;
  for (int y = 0; y < misfit.height; ++y)
    for (int x = 0; x < misfit.width; ++x)
      if (outsideAny(shifts, x, y, misfit.width, misfit.height)) misfit.row(0, y)[x] = 0;
}

}  // namespace

float solveAuto(const EstimatorContext& context, const ShotSignal& signal,
                const std::vector<ShotShift>& shifts, SolvedSet& set, const Progress& progress) {
  Shrinkage shrinkage(context, signal);
  const int lights = context.plan.lights;
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
      progress.update(from + (to - from) * float(done += end - begin) / float(runs),
                      "Telling the lights apart");
    });
  };

  // What the second stream needs of the first waits in planes of the answer that are not written yet.
  float* misfit = set.quality.plane(kResidual);
  float* variance = set.quality.plane(kSigma);
  float* odds = set.quality.plane(kModel);
  float* guide = lights > 1 ? set.contributions[1].plane(1) : nullptr;
  eachRun(0.1F, 0.5F, [&](size_t first, const PixelRun& in, MatteRun fit) {
    fit.misfit = misfit + first;
    fit.shareVariance = variance + first;
    shrinkage.matte().fit(in, fit);
    limitVariance(variance + first, in.count);
    if (guide)
      writeGuide(fit.reflectance[0], fit.reflectance[1], fit.reflectance[2], guide + first, in.count);
  });

  const ImageSpan quality = set.quality.span();
  const ImageSpan edges = set.contributions[0].span().channelRange(2, 1);
  const float squaredShift = squaredEdgeShift(signal, context.noise, quality.channelRange(kResidual, 1),
                                              shrinkage.matte().freedom());
  float* factor = squaredShift > 0 ? edges.row(0, 0) : nullptr;
  if (factor) {
    edgeNoiseFactor(signal, context.noise, squaredShift, edges);
    divide(factor, misfit, signal.pixelCount());
  }
  shrinkage.learn(signal, factor);
  trustOutside(shifts, quality.channelRange(kResidual, 1));

  const float freedom = float(std::max(shrinkage.matte().freedom(), 1));
  localOdds(quality.channelRange(kResidual, 1), freedom + 3.5F * std::sqrt(2 * freedom),
            quality.channelRange(kModel, 1));
  if (lights > 1) poolTwice(context.noise, set);

  eachRun(0.5F, 0.9F, [&](size_t first, const PixelRun& in, const MatteRun& fit) {
    shrinkage.matte().assess(in, fit);
    const float* noise = factor ? factor + first : nullptr;
    takeAway(fit.shareVariance, variance + first, fit.variance, in.count);
    if (noise) multiply(noise, fit.variance, size_t(in.count));
    const SolvedRun out = runAt(set, first);
    shrinkage.finish(in, fit, {misfit + first, odds + first, noise}, out, odds + first);
    writeBeta(lights, in.count, out);
  });
  return std::sqrt(squaredShift);
}

}  // namespace swaplight
