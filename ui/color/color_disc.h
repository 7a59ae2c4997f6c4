#pragma once

#include "core/color/rgb.h"

namespace swaplight {

/// A disc of colours to press or drag in: white in the middle, all hues around the rim (red at the right,
/// then clockwise), so that one drag is hue and saturation. Shift drags ten times finer. `hsv`: see
/// core/color/hsv.h; the value stays, that of black becomes 1. True in frames in which it changes.
bool colorDisc(const char* id, Rgb& hsv, float side);

}  // namespace swaplight
