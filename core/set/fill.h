#pragma once

#include <cstdint>
#include <vector>

#include "core/image/image.h"

namespace swaplight {

/// Replaces the marked pixels of every channel by what lies around them: push-pull (averages of the known
/// pixels on ever coarser grids, brought back down by bilinear interpolation; Gortler et al. 1996). Smooth,
/// exact elsewhere, and never NaN; where nothing at all is known the result is 0.
void fillFromNeighbours(Image& image, const std::vector<uint8_t>& missing);

}  // namespace swaplight
