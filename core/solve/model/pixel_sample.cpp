#include "core/solve/model/pixel_sample.h"

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

bool everyChannelHasAValue(const PixelRun& run, int shots, int pixel) {
  for (int c = 0; c < 3; ++c) {
    bool any = false;
    for (int k = 0; k < shots; ++k) any |= std::isfinite(run.signal[k][c][pixel]);
    if (!any) return false;
  }
  return true;
}

}  // namespace

PackedRun pixelSample(const ShotSignal& signal, int shots, size_t count, std::vector<size_t>* index,
                      SamplePixels which) {
  const size_t pixels = signal.pixelCount();
  const size_t runs = std::max<size_t>(1, std::min(pixels, count) / kMostLanes);
  PackedRun sample(shots, runs * kMostLanes);
  std::vector<float> scratch;
  for (size_t r = 0; r < runs; ++r) {
    // Runs start on a cache line, so that kernels may load whole ones.
    const size_t first = r * pixels / runs / kMostLanes * kMostLanes;
    const int length = int(std::min<size_t>(kMostLanes, pixels - first));
    PixelRun in;
    signal.run(first, length, true, scratch, in);
    for (int p = 0; p < length; ++p) {
      const bool whole = !signal.flagged(first + size_t(p), 1);
      if (!whole && (which == SamplePixels::Whole || !everyChannelHasAValue(in, shots, p))) continue;
      sample.add(in, p);
      if (index) index->push_back(first + size_t(p));
    }
  }
  return sample;
}

}  // namespace swaplight
