#pragma once

#include <cstdint>

#include "core/view/display/view_settings.h"

namespace swaplight {

/// Draws diagonal stripes over pixels of a window (8-bit R G B A, rows without gaps): rising ones in red
/// where the brightest channel reaches `high`, falling ones in blue where it stays below `low`. The stripes
/// stay where they are while the picture moves under them.
void drawZebra(const Zebra& zebra, int width, int height, uint8_t* rgba);

}  // namespace swaplight
