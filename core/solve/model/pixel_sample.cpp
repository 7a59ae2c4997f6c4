#include "core/solve/model/pixel_sample.h"

#include <algorithm>

namespace swaplight {

PackedRun pixelSample(const ShotSignal& signal, int shots, size_t count, std::vector<size_t>* index) {
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
    for (int p = 0; p < length; ++p)
      if (!signal.flagged(first + size_t(p), 1)) {
        sample.add(in, p);
        if (index) index->push_back(first + size_t(p));
      }
  }
  return sample;
}

}  // namespace swaplight
