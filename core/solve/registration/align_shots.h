#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/set/shot_shift.h"

namespace swaplight {

/// Registers every shot to the first, to a fraction of a pixel: a translation, and a turn and zoom about the
/// middle where sixteen parts of the picture surely show one. The light differs between the shots, so that
/// what is compared is the strength of the edges of log luminance over their local mean (part_shifts.h),
/// coarse to fine. A shot that correlates too little, or would move by more than a twelfth of the picture, is
/// not found.
/// Throws Stopped.
[[nodiscard]] std::vector<ShotShift> measureShifts(const CapturePixels& pixels,
                                                   const Progress& progress = {});

/// A shift that is worth resampling for (moved_shots.h): beyond what registering is good to under different
/// lights, and twice as far as the parts of the picture disagree, across or down, or as turned.
[[nodiscard]] bool worthMoving(const ShotShift& shift);

/// Whether a pixel's value comes from outside one of the moved shots.
[[nodiscard]] bool outsideAny(const std::vector<ShotShift>& shifts, int x, int y, int width, int height);

/// How far the corner is displaced, in pixels, that moves farthest of all shots worth moving; 0: none is.
[[nodiscard]] float farthestMove(const std::vector<ShotShift>& shifts, int width, int height);

/// What a person must know who wants the shots aligned: those that were not found, by their files.
[[nodiscard]] std::vector<std::string> shiftWarnings(const std::vector<ShotShift>& shifts,
                                                     const std::vector<std::string>& files);
[[nodiscard]] std::vector<std::string> shiftWarnings(const std::vector<ShotShift>& shifts,
                                                     const Capture& capture);

}  // namespace swaplight
