#pragma once

#include "core/color/rgb.h"

namespace swaplight {

/// The colour map viridis (van der Walt and Smith, 2015): from dark violet over green to yellow, as even
/// steps of lightness. `t` is clamped to 0..1; the result is an sRGB-encoded colour 0..1.
[[nodiscard]] Rgb viridis(float t);

}  // namespace swaplight
