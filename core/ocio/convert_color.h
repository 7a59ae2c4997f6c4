#pragma once

#include <string>

#include "core/color/rgb.h"
#include "core/ocio/color_config.h"

namespace swaplight {

/// One colour from a colour space to another. What the new primaries cannot mix is negative there. Throws
/// InputError on an unknown space.
[[nodiscard]] Rgb convertColor(const ColorConfig& config, const Rgb& color, const std::string& from,
                               const std::string& to);

}  // namespace swaplight
