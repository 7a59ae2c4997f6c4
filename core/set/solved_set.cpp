#include "core/set/solved_set.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/set/shares_kernel.h"

namespace swaplight {

void keepHighlightsInLights(SolvedSet& set) {
  parallelRows(set.highlights.empty() ? 0 : set.height(), 64, [&](int begin, int end) {
    const ptrdiff_t first = ptrdiff_t{begin} * set.width();
    const ptrdiff_t last = ptrdiff_t{end} * set.width();
    for (size_t i = 0; i < set.highlights.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        float* highlight = set.highlights[i].plane(c);
        const float* light = set.contributions[i].plane(c);
        for (ptrdiff_t p = first; p < last; ++p)
          highlight[p] = std::max(0.0F, std::min(highlight[p], light[p]));
      }
  });
}

Image sumAtUnitWhite(const SolvedSet& set) {
  Image sum = set.contributions.front().clone();
  parallelRows(set.height(), 64, [&](int begin, int end) {
    const ptrdiff_t first = static_cast<ptrdiff_t>(begin) * set.width();
    const ptrdiff_t last = static_cast<ptrdiff_t>(end) * set.width();
    const auto add = [&](const Image& image) {
      for (int c = 0; c < 3; ++c) {
        float* out = sum.plane(c);
        const float* in = image.plane(c);
        for (ptrdiff_t p = first; p < last; ++p) out[p] += in[p];
      }
    };
    for (size_t i = 1; i < set.contributions.size(); ++i) add(set.contributions[i]);
    if (set.ambient) add(*set.ambient);
  });
  return sum;
}

void sharesOf(int lights, const float* const* contributions, float* const* shares, size_t count) {
  SWAPLIGHT_KERNEL(shareRun)(lights, contributions, shares, count);
}

void updateBeta(SolvedSet& set) {
  const int lights = set.lightCount();
  ImageSpec spec{set.contributions.front().width(), set.contributions.front().height(), {}, "data"};
  for (const Light& light : set.capture.lights) spec.channels.push_back("beta." + light.name);
  if (set.beta.spec() != spec) set.beta = Image(spec);
  parallelRows(spec.height, 64, [&](int begin, int end) {
    const size_t first = size_t(begin) * size_t(spec.width);
    std::vector<const float*> contributions;
    std::vector<float*> shares;
    for (int i = 0; i < lights; ++i) {
      for (int c = 0; c < 3; ++c) contributions.push_back(set.contributions[size_t(i)].plane(c) + first);
      shares.push_back(set.beta.plane(i) + first);
    }
    sharesOf(lights, contributions.data(), shares.data(), size_t(end - begin) * size_t(spec.width));
  });
}

}  // namespace swaplight
