#pragma once

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/filter/frame_filter.h"
#include "core/ocio/color_config.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// Camera looks before the frame: on the photographs that a set is solved from, or on what one light gives. A
/// look's filters for a display see plain sRGB, and what they make is decoded by its curve: both stay light.

/// Each photograph, and the ambient one, under the look. What was saturated, and what the look makes of it,
/// is saturated afterwards; pixels that are not finite stay so. Adds a warning that lights add up in light
/// alone. Throws InputError, ResourceError, Stopped.
void filterShots(const ColorConfig& config, CapturePixels& pixels, FrameFilter& look,
                 const Progress& progress = {});

/// One light's contribution at unit white under the look; negative light becomes 0. beta follows. Throws as
/// filterShots.
void filterLight(const ColorConfig& config, SolvedSet& set, size_t light, FrameFilter& look,
                 const Progress& progress = {});

}  // namespace swaplight
