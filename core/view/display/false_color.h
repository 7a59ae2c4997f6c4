#pragma once

#include <span>

#include "core/color/rgb.h"

namespace swaplight {

/// A range of luminance and the colour that stands for it.
struct FalseColorBand {
  float stops;        ///< from middle grey (0.18): the band begins here, and ends where the next one begins
  Rgb color;          ///< display code values 0..1
  const char* label;  ///< for the legend
};

/// From dark to bright, a band a stop. The first also holds everything darker. Cold colours lie below middle
/// grey, grey at it, warm ones above; the ends are black and white.
[[nodiscard]] std::span<const FalseColorBand> falseColorBands();

/// The colour (display code values 0..1) of a scene-linear luminance; what is not positive or not a number is
/// the darkest.
[[nodiscard]] Rgb falseColor(float luminance);

}  // namespace swaplight
