#pragma once

#include <algorithm>
#include <cmath>

#include "core/image/pixel_rect.h"

namespace swaplight {

// The edges of shapes that are formulas.

/// 1 inside, 0 outside, smooth over `feather` pixels around a distance of 0 (outside is positive).
inline float coverage(float distance, float feather) {
  return std::clamp(.5f - distance / std::max(feather, 1.f), 0.f, 1.f);
}

/// std::hypot guards against overflow that pictures cannot reach, and is slow.
inline float lengthOf(float x, float y) {
  return std::sqrt(x * x + y * y);
}

/// From 0 to 1 without a kink at either end.
inline float smoothStep(float t) {
  t = std::clamp(t, 0.f, 1.f);
  return t * t * (3 - 2 * t);
}

/// The pixels that a shape within this box can reach with its soft edge.
inline PixelRect pixelsAround(float x0, float y0, float x1, float y1, float feather) {
  const float air = std::max(feather, 1.f) / 2 + 1;
  const int left = static_cast<int>(std::floor(x0 - air));
  const int top = static_cast<int>(std::floor(y0 - air));
  return {left, top, static_cast<int>(std::ceil(x1 + air)) - left,
          static_cast<int>(std::ceil(y1 + air)) - top};
}

}  // namespace swaplight
