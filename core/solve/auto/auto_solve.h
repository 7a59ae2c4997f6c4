#pragma once

#include "core/base/progress.h"
#include "core/set/solved_set.h"
#include "core/solve/auto/auto_tuning.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"
#include "core/solve/registration/align_shots.h"

namespace swaplight {

/// Model `auto`, in two streams over the shots. First the matte fit of every pixel; then its proportions are
/// pooled with the neighbours' where noise hides them (poolShares), and pixels that the matte model does not
/// explain are given what they need beyond it (Shrinkage), the more readily where their neighbours need it
/// too. Fills contributions, residual, sigma and model of `set`.
/// Returns how far the shots seem to lie from one another, in pixels (0: nothing to see; edge_noise.h).
/// `shifts`: what the shots were moved by; beyond their edges the matte model is all that is asked of a
/// pixel. `mayHaveMoved`: whether misfit at edges may be that of shots that do not lie on one another.
float solveAuto(const EstimatorContext& context, const ShotSignal& signal,
                const std::vector<ShotShift>& shifts, bool mayHaveMoved, const AutoTuning& tuning,
                SolvedSet& set, const Progress& progress);

}  // namespace swaplight
