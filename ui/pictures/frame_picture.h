#pragma once

#include "core/image/small_picture.h"
#include "core/ocio/color_config.h"
#include "core/relight/rig.h"
#include "core/view/display/display_table.h"
#include "ui/pictures/view_pictures.h"

namespace swaplight {

/// The whole set under a rig, at most `width` x `height`, as it is shown. `pictures`: the set's. `table`:
/// from its colour space to the display.
[[nodiscard]] SmallPicture framePicture(const SolvedSet& set, const ViewPictures& pictures,
                                        const ColorConfig& config, const DisplayTable& table, const Rig& rig,
                                        int width, int height);

}  // namespace swaplight
