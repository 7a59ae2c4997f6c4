#pragma once

#include <string>

#include "core/ocio/color_config.h"
#include "core/view/display/baked_view.h"

namespace swaplight {

/// OpenColorIO's processor for a view, without clamping to 0..1: what tables are made from. Throws InputError
/// where the configuration lacks the space, the display, the view or a look. Does not refer to the
/// configuration later.
[[nodiscard]] ViewFunction exactView(const ColorConfig& config, const std::string& colorSpace,
                                     const DisplayChoice& choice);

}  // namespace swaplight
