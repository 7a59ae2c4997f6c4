#pragma once

#include <string>

#include "core/color/color_config.h"
#include "core/view/baked_view.h"

namespace swaplight {

/// OpenColorIO's processor for a view, without clamping to 0..1: what tables are made from. Throws InputError
/// where the configuration lacks the space, the display or the view. Does not refer to the configuration
/// later.
[[nodiscard]] ViewFunction exactView(const ColorConfig& config, const std::string& colorSpace,
                                     const std::string& display, const std::string& view);

}  // namespace swaplight
