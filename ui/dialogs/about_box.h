#pragma once

#include <string>

#include "core/ocio/color_config.h"

namespace swaplight {

/// What this program is, who computes the picture, and what it is made of.
/// `engine`: who computes it, in words.
void drawAboutBox(const std::string& engine, const ColorConfig& config, bool* open);

}  // namespace swaplight
