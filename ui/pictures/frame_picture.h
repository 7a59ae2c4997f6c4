#pragma once

#include "core/image/small_picture.h"
#include "core/ocio/color_config.h"
#include "core/relight/rig.h"
#include "core/view/display/display_table.h"
#include "ui/pictures/live_set.h"

namespace swaplight {

/// The whole set under a rig, at most `width` x `height`, as it is shown. `table`: from the set's colour
/// space to the display. For the interface's thread.
[[nodiscard]] SmallPicture framePicture(const LiveSet& live, const ColorConfig& config,
                                        const DisplayTable& table, const Rig& rig, int width, int height);

}  // namespace swaplight
