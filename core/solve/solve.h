#pragma once

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/set/shot_shift.h"
#include "core/set/solved_set.h"
#include "core/solve/model/solve_options.h"
#include "core/solve/solve_tuning.h"

namespace swaplight {

/// Separates the lights of a capture: the one entry point to every estimator. `movedBy`: what the photographs
/// were moved onto the first by already (movedShots); empty: the options say whether to. Throws InputError
/// where an option is out of its range or the capture cannot be solved (equal lights, more lights than shots
/// can tell, an estimator that does not fit), Stopped when asked to.
[[nodiscard]] SolvedSet solve(const Capture& capture, const CapturePixels& pixels,
                              const SolveOptions& options, const Progress& progress = {},
                              const SolveTuning& tuning = {}, const std::vector<ShotShift>& movedBy = {});

}  // namespace swaplight
