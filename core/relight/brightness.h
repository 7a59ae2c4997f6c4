#pragma once

#include <glm/common.hpp>

#include "core/color/rgb.h"

namespace swaplight {

/// What a light can be brightened by in all: with solved sets, whose values lie below 1e25, frames stay
/// finite.
inline constexpr float kMostBrightness = 0x1p40F;

[[nodiscard]] inline Rgb brightnessLimited(const Rgb& factor) {
  return glm::min(factor, Rgb(kMostBrightness));
}

}  // namespace swaplight
