#include "core/solve/solved_set.h"

#include "core/parallel.h"

namespace swaplight {

Image allWhite(const SolvedSet& set) {
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

void updateBeta(SolvedSet& set) {
  const int lights = set.lightCount();
  ImageSpec spec{set.contributions.front().width(), set.contributions.front().height(), {}, "data"};
  for (const Light& light : set.capture.lights) spec.channels.push_back("beta." + light.name);
  if (set.beta.spec() != spec) set.beta = Image(spec);
  parallelRows(spec.height, 64, [&](int begin, int end) {
    const ptrdiff_t first = static_cast<ptrdiff_t>(begin) * spec.width;
    const ptrdiff_t last = static_cast<ptrdiff_t>(end) * spec.width;
    for (ptrdiff_t p = first; p < last; ++p) {
      float total = 0;
      for (int i = 0; i < lights; ++i) {
        const Image& t = set.contributions[static_cast<size_t>(i)];
        const float grey = t.plane(0)[p] + t.plane(1)[p] + t.plane(2)[p];
        set.beta.plane(i)[p] = grey;
        total += grey;
      }
      const float scale = total > 0 ? 1 / total : 0;
      for (int i = 0; i < lights; ++i) set.beta.plane(i)[p] *= scale;
    }
  });
}

}  // namespace swaplight
