#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/set/shot_shift.h"
#include "core/solve/causes/cause_tuning.h"

namespace swaplight {

/// What moves each shot onto the first: by edges (measureShifts), and where some is worth moving, better by
/// Gauss-Newton: the shots are moved, the Moved cause of misfitCauses() is fitted to what the matte model
/// then misses, and added. Edges move with the light; what the photographs miss of each other does not. Shots
/// that are not worth moving stay; all stay where edges have them where no pixel has freedom, where a light
/// colour is unknown, where the capture is so large that it would take longer than solving, or where that
/// leaves no less misfit. `noise`: the sensor's, if it is told otherwise than by the capture. Throws Stopped.
[[nodiscard]] std::vector<ShotShift> shiftsOfShots(const Capture& capture, const CapturePixels& photographs,
                                                   const std::optional<SensorNoise>& noise = {},
                                                   const Progress& progress = {},
                                                   const CauseTuning& tuning = {});

}  // namespace swaplight
