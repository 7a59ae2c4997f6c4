#pragma once

#include <vector>

#include "core/capture/capture_pixels.h"
#include "core/set/shot_shift.h"

namespace swaplight {

/// The shots moved onto the first, by a Lanczos kernel of six taps in linear light. Saturated and broken
/// values stay so, with the pixels that they would have leaked into. What lies outside a shot repeats its
/// edge: see outsideAny. Shots that are not worth moving (align_shots.h) and the ambient picture stay.
[[nodiscard]] CapturePixels movedShots(const CapturePixels& pixels, const std::vector<ShotShift>& shifts);

}  // namespace swaplight
