#pragma once

#include "core/simd/padding.h"
#include "core/simd/simd.h"

namespace swaplight {

/// Floats behind the last value of a row that are read, and not used.
inline constexpr int kSmallRowPadding = 2 * kMostLanes;

/// out[i], linear between the pixels of a small row, at x + step * i; step: 0..1. `values` holds its pixels
/// from `first` on, as many as are needed and room for kSmallRowPadding more; `last` is the row's last. `out`
/// has room for whole lanes.
SWAPLIGHT_DECLARE_KERNEL(mixColumns, const float* values, int first, int last, float x, float step, int count,
                         float* out)

}  // namespace swaplight
