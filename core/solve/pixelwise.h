#pragma once

#include "core/base/progress.h"
#include "core/set/solved_set.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// Solves every pixel by itself, in one stream over the shots: contributions, residual, sigma, model and
/// beta. Pixels with values that are left out go to the matte model where the estimator cannot do without
/// them.
void solvePixelwise(const EstimatorInfo& info, const EstimatorContext& context, const ShotSignal& signal,
                    SolvedSet& set, const Progress& progress);

}  // namespace swaplight
