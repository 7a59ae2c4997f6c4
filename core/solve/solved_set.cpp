#include "core/solve/solved_set.h"

#include <algorithm>

#include "core/parallel.h"
#include "core/simd.h"

namespace swaplight {
namespace {

SWAPLIGHT_SIMD void addGrey(const float* __restrict r, const float* __restrict g, const float* __restrict b,
                            float* __restrict grey, float* __restrict total, size_t count) {
  for (size_t p = 0; p < count; ++p) {
    grey[p] = r[p] + g[p] + b[p];
    total[p] += grey[p];
  }
}

SWAPLIGHT_SIMD void invert(float* x, size_t count) {
  for (size_t p = 0; p < count; ++p) x[p] = x[p] > 0 ? 1 / x[p] : 0;
}

SWAPLIGHT_SIMD void multiply(float* __restrict x, const float* __restrict by, size_t count) {
  for (size_t p = 0; p < count; ++p) x[p] *= by[p];
}

}  // namespace

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

void sharesOf(int lights, const float* const* contributions, float* const* shares, size_t count) {
  // In blocks that stay in the first-level cache, so that each plane is read from memory once.
  constexpr size_t kBlock = 512;
  for (size_t first = 0; first < count; first += kBlock) {
    const size_t length = std::min(kBlock, count - first);
    alignas(64) float total[kBlock];
    std::fill_n(total, length, 0.0F);
    for (int i = 0; i < lights; ++i)
      addGrey(contributions[3 * i] + first, contributions[3 * i + 1] + first,
              contributions[3 * i + 2] + first, shares[i] + first, total, length);
    invert(total, length);
    for (int i = 0; i < lights; ++i) multiply(shares[i] + first, total, length);
  }
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
