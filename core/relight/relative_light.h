#pragma once

#include <span>

#include "core/color/rgb.h"
#include "core/image/image.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// The longest side of a picture of relative light: 38 MB on the graphics card at most.
inline constexpr int kRelativeLightSide = 2048;

/// How much more light one picture holds than another of its size, R G B by pixel: 1 where both are dark.
/// Where the second is dark beside its mean, it tends to the ratio of the means. Both in linear light; what
/// is below 0 counts as 0.
[[nodiscard]] Image relativeLight(const Image& lit, const Image& unit);

/// How much more light the set's lights give than at unit white: sum of factor[i] * T[i] over sum of T[i],
/// ambient with either, as a picture of the whole frame, its longest side at most kRelativeLightSide. A
/// thing that stood there and was photographed in white light would, lit by these lights, look so many times
/// brighter, in the set's primaries. Factors one a light (checked).
[[nodiscard]] Image relativeLight(const SolvedSet& set, std::span<const Rgb> factors, float ambientFactor);

}  // namespace swaplight
