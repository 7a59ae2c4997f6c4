#pragma once

#include <cstddef>

#include "core/simd/simd.h"

namespace swaplight {

/// See sharesOf: `count` pixels, each plane read and written once.
SWAPLIGHT_DECLARE_KERNEL(shareRun, int lights, const float* const* contributions, float* const* shares,
                         size_t count)

}  // namespace swaplight
