#include "core/solve/estimators/demultiplex_kernel.h"

#include "core/simd/lanes.h"

namespace swaplight::SWAPLIGHT_LEVEL {
namespace {

/// kLights lights of as many shots; 0: any numbers.
template <int kLights, bool kClamp>
SWAPLIGHT_LANES bool demultiplex(const DemultiplexRun& run) {
  constexpr int kMostShots = kLights > 0 ? kLights : kMaxShots;
  const int n = kLights > 0 ? kLights : run.lights;
  const int m = kLights > 0 ? kLights : run.shots;
  Lanes lowest = splat(0);
  for (int at = 0; at < run.count; at += kLanes) {
    Lanes y[kMostShots];
    for (int k = 0; k < m; ++k) y[k] = load(run.in[k] + at);
    for (int i = 0; i < n; ++i) {
      Lanes sum = splat(0);
      for (int k = 0; k < m; ++k) sum += run.inverse[i * m + k] * y[k];
      // The last lanes of a run may lie beyond it: what is there does not count.
      if (!kClamp && at + kLanes <= run.count) lowest = smaller(sum, lowest);
      store(run.out[i] + at, kClamp ? larger(sum, splat(0)) : sum);
    }
  }
  return kClamp || run.count % kLanes != 0 || any(lowest < 0);
}

template <bool kClamp>
SWAPLIGHT_LANES bool demultiplexAny(const DemultiplexRun& run) {
  if (run.lights == 2 && run.shots == 2) return demultiplex<2, kClamp>(run);
  if (run.lights == 3 && run.shots == 3) return demultiplex<3, kClamp>(run);
  if (run.lights == 4 && run.shots == 4) return demultiplex<4, kClamp>(run);
  if (run.lights == 8 && run.shots == 8) return demultiplex<8, kClamp>(run);
  return demultiplex<0, kClamp>(run);
}

}  // namespace

void demultiplexRun(const DemultiplexRun& run, bool* negative) {
  if (negative)
    *negative = demultiplexAny<false>(run);
  else
    demultiplexAny<true>(run);
}

}  // namespace swaplight::SWAPLIGHT_LEVEL
