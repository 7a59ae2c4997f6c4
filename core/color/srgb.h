#pragma once

#include <cmath>

#include "core/color/rgb.h"

namespace swaplight {

// The sRGB transfer function (IEC 61966-2-1), 0..1 to 0..1. Negative values are mirrored.

[[nodiscard]] inline float linearFromSrgb(float encoded) {
  const float a = std::fabs(encoded);
  return std::copysign(a <= 0.04045f ? a / 12.92f : std::pow((a + 0.055f) / 1.055f, 2.4f), encoded);
}

[[nodiscard]] inline float srgbFromLinear(float linear) {
  const float a = std::fabs(linear);
  return std::copysign(a <= 0.0031308f ? 12.92f * a : 1.055f * std::pow(a, 1 / 2.4f) - 0.055f, linear);
}

[[nodiscard]] inline Rgb linearFromSrgb(const Rgb& encoded) {
  return {linearFromSrgb(encoded.x), linearFromSrgb(encoded.y), linearFromSrgb(encoded.z)};
}

[[nodiscard]] inline Rgb srgbFromLinear(const Rgb& linear) {
  return {srgbFromLinear(linear.x), srgbFromLinear(linear.y), srgbFromLinear(linear.z)};
}

}  // namespace swaplight
