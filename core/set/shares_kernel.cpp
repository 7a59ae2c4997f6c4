#include "core/set/shares_kernel.h"

#include "core/simd/lanes.h"

namespace swaplight::SWAPLIGHT_LEVEL {
namespace {

SWAPLIGHT_LANES Lanes greyAt(const float* const* channels, size_t at) {
  return load(channels[0] + at) + load(channels[1] + at) + load(channels[2] + at);
}

SWAPLIGHT_LANES float greyOf(const float* const* channels, size_t at) {
  return channels[0][at] + channels[1][at] + channels[2][at];
}

/// kN lights, whose greys stay in registers; 0: any number, whose greys are summed twice.
template <int kN>
[[gnu::always_inline]] inline void shares(int lights, const float* const* contributions, float* const* out,
                                          size_t count) {
  const size_t n = kN > 0 ? size_t(kN) : size_t(lights);
  size_t at = 0;
  for (; at + kLanes <= count; at += kLanes) {
    Lanes grey[kN > 0 ? kN : 1];
    Lanes total = splat(0);
    for (size_t i = 0; i < n; ++i) {
      const Lanes here = greyAt(contributions + 3 * i, at);
      if (kN > 0) grey[i] = here;
      total += here;
    }
    const Lanes scale = select(total > 0, 1 / total, splat(0));
    for (size_t i = 0; i < n; ++i)
      store(out[i] + at, (kN > 0 ? grey[i] : greyAt(contributions + 3 * i, at)) * scale);
  }
  for (; at < count; ++at) {
    float total = 0;
    for (size_t i = 0; i < n; ++i) total += greyOf(contributions + 3 * i, at);
    const float scale = total > 0 ? 1 / total : 0;
    for (size_t i = 0; i < n; ++i) out[i][at] = greyOf(contributions + 3 * i, at) * scale;
  }
}

}  // namespace

void shareRun(int lights, const float* const* contributions, float* const* out, size_t count) {
  if (lights == 2) return shares<2>(2, contributions, out, count);
  if (lights == 3) return shares<3>(3, contributions, out, count);
  if (lights == 4) return shares<4>(4, contributions, out, count);
  shares<0>(lights, contributions, out, count);
}

}  // namespace swaplight::SWAPLIGHT_LEVEL
