#pragma once

#include "core/color/rgb.h"

namespace swaplight {

/// CIE 1931 x, y (2 degree observer).
struct Chromaticity {
  double x = 0;
  double y = 0;
};

/// CIE 1960 u, v: the plane in which correlated colour temperature and Duv are defined.
struct Uv {
  double u = 0;
  double v = 0;
};

/// The white of Rec.709 and sRGB (ITU-R BT.709): CIE D65.
inline constexpr Chromaticity kD65{0.3127, 0.3290};

[[nodiscard]] Uv uvFromXy(const Chromaticity& xy);
[[nodiscard]] Chromaticity xyFromUv(const Uv& uv);

/// The relative luminance Y of a linear Rec.709 colour.
[[nodiscard]] float luminance(const Rgb& rec709);

/// Linear Rec.709 of luminance 1. Outside of the gamut the negative channels become 0, and the luminance is
/// made 1 again. `xy.y` > 0.
[[nodiscard]] Rgb rec709FromXy(const Chromaticity& xy);

/// The chromaticity of a linear Rec.709 colour; D65 for black.
[[nodiscard]] Chromaticity xyFromRec709(const Rgb& rec709);

}  // namespace swaplight
