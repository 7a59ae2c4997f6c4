#include "core/solve/pixelwise.h"

#include <algorithm>
#include <atomic>
#include <vector>

#include "core/base/parallel.h"
#include "core/solve/model/pixel_batch.h"

namespace swaplight {
namespace {

/// Solves the flagged pixels of a run again with an estimator that can leave values out.
void repairRun(const ShotSignal& signal, size_t first, int count, const Estimator& masking, int lights,
               int shots, const SolvedRun& out) {
  std::vector<int> index;
  for (int p = 0; p < count; ++p)
    if (signal.flags()[first + size_t(p)]) index.push_back(p);
  if (index.empty()) return;
  std::vector<float> scratch;
  PixelRun all;
  signal.run(first, count, true, scratch, all);
  const PixelBatch batch(all, std::move(index), shots, lights);
  masking.estimate(batch.in(), batch.out());
  batch.scatter(out);
}

}  // namespace

void solvePixelwise(const EstimatorInfo& info, const EstimatorContext& context, const ShotSignal& signal,
                    SolvedSet& set, const Progress& progress) {
  const auto estimator = info.make(context);
  const auto masking =
      info.masks || signal.flags().empty() ? nullptr : estimatorFor(Model::Lambert).make(context);
  const int runs = int((signal.pixelCount() + kRun - 1) / kRun);
  std::atomic<int> done = 0;
  parallelRows(runs, 4, [&](int begin, int end) {
    std::vector<float> scratch;
    for (int r = begin; r < end; ++r) {
      const size_t first = size_t(r) * kRun;
      const int count = int(std::min<size_t>(kRun, signal.pixelCount() - first));
      PixelRun in;
      signal.run(first, count, info.masks, scratch, in);
      const SolvedRun out = runAt(set, first);
      estimator->estimate(in, out);
      if (masking && signal.flagged(first, count))
        repairRun(signal, first, count, *masking, context.lighting.lights, context.lighting.shots, out);
      writeBeta(context.lighting.lights, count, out);
    }
    progress.update(float(done += end - begin) / float(runs), "Separating lights");
  });
}

}  // namespace swaplight
