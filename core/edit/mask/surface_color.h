#pragma once

#include "core/color/rgb.h"
#include "core/edit/mask/prepared_mask.h"

namespace swaplight {

/// The mean colour of what a mask lets through, at unit white: linear light, 1 where that is dark or nothing.
[[nodiscard]] Rgb surfaceColor(const SolvedSet& set, const PreparedMask& mask);

}  // namespace swaplight
