#pragma once

#include "core/color/rgb.h"

namespace swaplight {

// Hue, saturation and value (Smith 1978), all 0..1; a hue of 1 is a full turn. Of sRGB-encoded colours, as
// every picker shows them; nothing here is linear light.

[[nodiscard]] Rgb rgbFromHsv(const Rgb& hsv);
/// The hue of a grey is 0.
[[nodiscard]] Rgb hsvFromRgb(const Rgb& rgb);

}  // namespace swaplight
