#pragma once

#include <string>
#include <vector>

#include "core/capture/capture_pixels.h"
#include "core/set/shot_shift.h"

namespace swaplight {

/// Registers every shot to the first: a translation, to a fraction of a pixel. The light differs between the
/// shots, so that what is compared is the strength of the edges of log luminance over their local mean, by
/// the enhanced correlation coefficient (Evangelidis and Psarakis 2008), coarse to fine. A shot that
/// correlates too little, or would move by more than a twelfth of the picture, is not found.
[[nodiscard]] std::vector<ShotShift> measureShifts(const CapturePixels& pixels);

/// A shift that is worth resampling for: beyond what registering is good to under different lights, and
/// twice as far as the parts of the picture disagree, across or down.
[[nodiscard]] bool worthMoving(const ShotShift& shift);

/// The shots moved onto the first, by a Lanczos kernel of six taps in linear light. Saturated and broken
/// values stay so, with the pixels that they would have leaked into. What lies outside a shot repeats its
/// edge: see outsideAny. The ambient picture stays.
[[nodiscard]] CapturePixels movedShots(const CapturePixels& pixels, const std::vector<ShotShift>& shifts);

/// Whether a pixel's value comes from outside one of the moved shots.
[[nodiscard]] bool outsideAny(const std::vector<ShotShift>& shifts, int x, int y, int width, int height);

/// What a person must know: shots that were not found.
[[nodiscard]] std::vector<std::string> shiftWarnings(const std::vector<ShotShift>& shifts);

}  // namespace swaplight
