#pragma once

#include "core/image/image.h"

namespace swaplight {

/// Of a picture developed from a mosaic of colour filters (camera raw): a channel counts as saturated, and is
/// set to 1, where a pixel beside it is at or above `clip`. Two of its three channels at a pixel were
/// interpolated from neighbours; from saturated ones they come out too small, without looking saturated
/// themselves.
void spreadSaturation(Image& image, float clip);

}  // namespace swaplight
