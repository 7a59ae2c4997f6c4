#pragma once

#include "core/set/solved_set.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"
#include "core/solve/registration/registration_tuning.h"

namespace swaplight {

/// Finds what moved between the shots and marks it kMoved in quality.flags; returns how many pixels.
///
/// Gloss and bounced light break the matte model as motion does, but they are still light of the lights: some
/// T >= 0 explains them. Motion asks for negative light. So a pixel that the solve leaves a misfit at is
/// solved again by non-negative least squares, and is a witness where even that leaves far more than the
/// noise (the light colours taken to be known no better than 2 %). Where witnesses are dense, the misfit
/// around them is taken for motion; small specks are not. Marked pixels are solved again by the matte model,
/// which has the least freedom to make nonsense of them.
/// Needs as many shots as lights: with fewer there is nothing to tell gloss and motion apart by, and nothing
/// is marked. Motion that happens to look like light is not found.
size_t markMoved(const EstimatorContext& context, const ShotSignal& signal, SolvedSet& set,
                 const MotionTuning& tuning = {});

}  // namespace swaplight
