#include "core/edit/pool/small_samples_kernel.h"

#include "core/simd/lanes.h"

namespace swaplight::SWAPLIGHT_LEVEL {

static_assert(2 * kLanes <= kSmallRowPadding);

// As many pixels as lanes lie between so few of the small row's that two registers hold these: the wanted
// ones are chosen there, which is several times faster than to fetch each from memory.
void mixColumns(const float* values, int first, int last, float x, float step, int count, float* out) {
  LaneMask lane{};
  for (int l = 0; l < kLanes; ++l) lane[l] = l;
  const Lanes steps = __builtin_convertvector(lane, Lanes) * step;
  const Lanes highest = splat(static_cast<float>(last));
  const LaneMask lastLeft = LaneMask{} + (last > 0 ? last - 1 : 0);
  const LaneMask lastRight = LaneMask{} + last;
  for (int i = 0; i < count; i += kLanes) {
    const Lanes place = smaller(larger(x + step * static_cast<float>(i) + steps, splat(0)), highest);
    LaneMask left = __builtin_convertvector(place, LaneMask);
    left = left < lastLeft ? left : lastLeft;
    const Lanes part = place - __builtin_convertvector(left, Lanes);
    LaneMask right = left + 1;
    right = right < lastRight ? right : lastRight;
    const int base = left[0];
    const Lanes near = load(values + (base - first));
    const Lanes far = load(values + (base - first) + kLanes);
    const Lanes a = __builtin_shuffle(near, far, left - base);
    const Lanes b = __builtin_shuffle(near, far, right - base);
    store(out + i, a + part * (b - a));
  }
}

}  // namespace swaplight::SWAPLIGHT_LEVEL
