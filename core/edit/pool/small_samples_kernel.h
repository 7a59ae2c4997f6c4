#pragma once

#include "core/simd/simd.h"

namespace swaplight {

/// How far behind the last value of a row it is read (and not used).
inline constexpr int kBeyondSmallRow = 2 * 16;

/// out[i], linear between the pixels of a small row, at x + step * i; step: 0..1. `values` holds its pixels
/// from `first` on, as many as are needed and room for kBeyondSmallRow more; `last` is the row's last. `out`
/// has room for whole lanes.
SWAPLIGHT_DECLARE_KERNEL(mixColumns, const float* values, int first, int last, float x, float step, int count,
                         float* out)

}  // namespace swaplight
