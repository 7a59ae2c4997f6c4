#pragma once

#include "core/edit/raster/mask_raster.h"
#include "core/shadow/result/shadow_outline.h"

namespace swaplight {

/// Closed lines around where a mask is above a half, in pixels of the picture (a pixel's centre lies at .5),
/// simplified to within half a pixel; the longest first. Outlines of a few pixels are left out.
[[nodiscard]] std::vector<Outline> maskOutline(const MaskRaster& mask);

}  // namespace swaplight
