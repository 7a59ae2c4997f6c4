#pragma once

#include <cmath>
#include <concepts>

#include "core/color/rgb.h"

namespace swaplight {

// The sRGB transfer function (IEC 61966-2-1), 0..1 to 0..1. Negative values are mirrored.

template <std::floating_point T>
[[nodiscard]] T linearFromSrgb(T encoded) {
  const T a = std::abs(encoded);
  return std::copysign(a <= T(0.04045) ? a / T(12.92) : std::pow((a + T(0.055)) / T(1.055), T(2.4)), encoded);
}

template <std::floating_point T>
[[nodiscard]] T srgbFromLinear(T linear) {
  const T a = std::abs(linear);
  return std::copysign(a <= T(0.0031308) ? T(12.92) * a : T(1.055) * std::pow(a, 1 / T(2.4)) - T(0.055),
                       linear);
}

[[nodiscard]] inline Rgb linearFromSrgb(const Rgb& encoded) {
  return {linearFromSrgb(encoded.x), linearFromSrgb(encoded.y), linearFromSrgb(encoded.z)};
}

[[nodiscard]] inline Rgb srgbFromLinear(const Rgb& linear) {
  return {srgbFromLinear(linear.x), srgbFromLinear(linear.y), srgbFromLinear(linear.z)};
}

}  // namespace swaplight
