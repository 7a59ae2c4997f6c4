#include "core/edit/stack/beta_histogram.h"

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

constexpr size_t kEnough = 400'000;  // pixels

}  // namespace

std::vector<float> betaHistogram(const SolvedSet& set, int light, int bins) {
  std::vector<float> counts(static_cast<size_t>(bins));
  const size_t pixels = set.beta.pixelCount();
  const size_t step = std::max<size_t>(1, pixels / kEnough);
  const auto last = static_cast<float>(bins - 1);
  for (int i = 0; i < set.beta.channelCount(); ++i) {
    if (light >= 0 && i != light) continue;
    const float* beta = set.beta.plane(i);
    for (size_t p = 0; p < pixels; p += step) {
      float all = 0;
      for (int k = 0; k < set.beta.channelCount(); ++k) all += set.beta.plane(k)[p];
      if (all > 0)
        counts[static_cast<size_t>(std::clamp(beta[p] * static_cast<float>(bins), 0.F, last))] += 1;
    }
  }
  const float most = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
  for (float& count : counts) count = most > 0 ? std::sqrt(count / most) : 0;
  return counts;
}

}  // namespace swaplight
