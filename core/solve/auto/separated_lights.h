#pragma once

#include "core/set/solved_set.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// How far the shots are pictures of one light each, 0 .. 1. A light's free contribution has the variance
/// (L'L)^-1_ii in a channel; had it been alone in the light that it gives the shots, 1 / (L'L)_ii. Their
/// ratio, the variance inflation of regression (Marquardt 1970), is what telling the lights apart costs.
/// Where it is 1 in every light and channel nothing needs to be told apart, and a model of the surface can
/// only take something away; 1 there, and 0 where it is more than a tenth larger.
[[nodiscard]] float separatedPart(const LightingMatrix& lighting);

/// Moves the contributions of `set` by `part` towards the free ones (model transport), and quality and beta
/// with them. Pixels with a value that is not finite stay: the free contribution would take it for 0.
void moveToFreeContributions(const EstimatorContext& context, const ShotSignal& signal, float part,
                             SolvedSet& set);

}  // namespace swaplight
