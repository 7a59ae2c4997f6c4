#pragma once

#include <string>

#include "core/color/rgb.h"

namespace swaplight {

inline constexpr float kSharesWidth = 250;  ///< of a card with bars, at scale 1

/// One light's share of a pixel in a line of its own: name, bar, per cent. `lit` sets it off from the others.
void drawShareBar(const std::string& name, float share, const Rgb& color, bool lit = false);

}  // namespace swaplight
