#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// What a click into the picture does to the chosen lights while a picking tool is in the hand. Pixel of the
/// picture.
void pickPixel(StudioContext& studio, Tool tool, int x, int y);

}  // namespace swaplight
