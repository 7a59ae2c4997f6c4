#pragma once

#include "core/simd/simd.h"

namespace swaplight::test {

/// What core/simd/lanes.h computes, for `count` numbers (a multiple of kMostLanes).
SWAPLIGHT_DECLARE_KERNEL(logarithms, const float* in, float* out, int count)
SWAPLIGHT_DECLARE_KERNEL(exponentials, const float* in, float* out, int count)
SWAPLIGHT_DECLARE_KERNEL(squareRoots, const float* in, float* out, int count)
/// Whether any of kMostLanes numbers is above 0.
SWAPLIGHT_DECLARE_KERNEL(anyPositive, const float* in, bool* found)

inline constexpr int kLargestSystem = 35;
/// kMostLanes systems of n equations at once: a [i (i + 1) / 2 + j][lane] is overwritten, x [i][lane] solved
/// in place.
SWAPLIGHT_DECLARE_KERNEL(solveSystems, int n, float* a, float* x)

}  // namespace swaplight::test
