#include "core/solve/auto_solve.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/parallel.h"
#include "core/solve/neighbourhood.h"
#include "core/solve/run_scratch.h"
#include "core/solve/shrinkage.h"

namespace swaplight {
namespace {

/// The part of a pixel's variance that is noise of its own. The rest, above all what is not known of the
/// light colours, is the same all over the picture: neighbours cannot take it away.
float independentPart(const NoiseModel& noise, const PixelRun& in, int shots, int p) {
  float signal = 0;
  int count = 0;
  for (int k = 0; k < shots; ++k)
    for (int c = 0; c < 3; ++c)
      if (const float y = in.signal[k][c][p]; y > 0) signal += y, ++count;
  if (count == 0) return 1;
  signal /= float(count);
  const float own = noise.constant + noise.linear * signal;
  return own / (own + noise.square * signal * signal);
}

/// Planes between the two streams.
enum Between { kMisfit = 0, kVariance = 1, kOdds = 2, kShares = 3 };

Image betweenPlanes(const SolvedSet& set) {
  ImageSpec spec = set.quality.spec();
  spec.channels.assign(size_t(kShares) + size_t(set.lightCount()), "");
  return Image(spec);
}

}  // namespace

void solveAuto(const EstimatorContext& context, const ShotSignal& signal, SolvedSet& set,
               const Progress& progress) {
  const Shrinkage shrinkage(context, signal);
  const int lights = context.plan.lights;
  Image between = betweenPlanes(set);
  const int runs = int((signal.pixelCount() + kRun - 1) / kRun);
  const auto eachRun = [&](float from, float to, const auto& work) {
    std::atomic<int> done = 0;
    parallelRows(runs, 4, [&](int begin, int end) {
      std::vector<float> scratch;
      MatteScratch fit(lights, kRun);
      for (int r = begin; r < end; ++r) {
        const size_t first = size_t(r) * kRun;
        PixelRun in;
        signal.run(first, int(std::min<size_t>(kRun, signal.pixelCount() - first)), true, scratch, in);
        work(first, in, fit.run());
      }
      progress.update(from + (to - from) * float(done += end - begin) / float(runs),
                      "Telling the lights apart");
    });
  };

  eachRun(0.1F, 0.5F, [&](size_t first, const PixelRun& in, const MatteRun& fit) {
    shrinkage.matte().fit(in, fit);
    std::copy_n(fit.misfit, in.count, between.plane(kMisfit) + first);
    for (int p = 0; p < in.count; ++p)
      between.plane(kVariance)[first + size_t(p)] =
          fit.shareVariance[p] * independentPart(context.noise, in, context.plan.shots, p);
    for (int i = 0; i < lights; ++i) std::copy_n(fit.share[i], in.count, between.plane(kShares + i) + first);
  });

  const ImageSpan planes = between.span();
  const float freedom = float(std::max(shrinkage.matte().freedom(), 1));
  localOdds(planes.channelRange(kMisfit, 1), freedom + 3.5F * std::sqrt(2 * freedom),
            planes.channelRange(kOdds, 1));
  if (lights > 1) poolShares(planes.channelRange(kShares, lights), planes.channelRange(kVariance, 1));

  eachRun(0.5F, 0.9F, [&](size_t first, const PixelRun& in, const MatteRun& fit) {
    for (int i = 0; i < lights; ++i) std::copy_n(between.plane(kShares + i) + first, in.count, fit.share[i]);
    shrinkage.matte().assess(in, fit);
    // Pooling took away part of the variance of the shares, which is nearly all of the contributions'.
    for (int p = 0; p < in.count; ++p) {
      const float before = fit.shareVariance[p] * independentPart(context.noise, in, context.plan.shots, p);
      const float after = std::min(between.plane(kVariance)[first + size_t(p)], before);
      fit.variance[p] = std::max(fit.variance[p] - (before - after), after);
    }
    const SolvedRun out = runAt(set, first);
    shrinkage.finish(in, fit, between.plane(kMisfit) + first, between.plane(kOdds) + first, out,
                     set.quality.plane(kModel) + first);
    writeBeta(lights, in.count, out);
  });
}

}  // namespace swaplight
