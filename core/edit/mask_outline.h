#pragma once

#include <array>
#include <vector>

#include "core/edit/mask_raster.h"

namespace swaplight {

/// Closed lines around where a mask is above a half, in pixels of the picture (a pixel's centre lies at .5),
/// simplified to within half a pixel; the longest first. Outlines of a few pixels are left out.
[[nodiscard]] std::vector<std::vector<std::array<float, 2>>> maskOutline(const MaskRaster& mask);

}  // namespace swaplight
