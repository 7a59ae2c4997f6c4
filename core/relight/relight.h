#pragma once

#include <span>

#include "core/color/rgb.h"
#include "core/image/image.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// The truth that every other renderer is compared with: out = sum of factor[i] * T[i] + ambientFactor *
/// ambient, in linear light, float32. `out` is R G B of the set's size, factors one a light (checked).
void relight(const SolvedSet& set, std::span<const Rgb> factors, float ambientFactor, ImageSpan out);
[[nodiscard]] Image relight(const SolvedSet& set, std::span<const Rgb> factors, float ambientFactor = 1);

}  // namespace swaplight
