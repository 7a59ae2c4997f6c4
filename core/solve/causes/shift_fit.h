#pragma once

#include <optional>
#include <vector>

#include "core/capture/capture_pixels.h"
#include "core/set/shot_shift.h"
#include "core/solve/causes/cause_tuning.h"

namespace swaplight {

/// Shifts made better by Gauss-Newton: the shots are moved, the Moved cause of misfitCauses() is fitted to
/// what the matte model then misses, and added. Edges alone (align_shots.h) move with the light; what the
/// photographs miss of each other does not. Shots that are not worth moving stay; all stay where no pixel has
/// freedom, where a light colour is unknown, or where that leaves no less misfit. `noise`: the sensor's, if
/// it is told otherwise than by the capture.
[[nodiscard]] std::vector<ShotShift> fittedShifts(const Capture& capture, const CapturePixels& photographs,
                                                  const std::vector<ShotShift>& shifts,
                                                  const std::optional<SensorNoise>& noise = {},
                                                  const CauseTuning& tuning = {});

}  // namespace swaplight
