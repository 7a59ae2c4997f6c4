#pragma once

#include "core/set/solved_set.h"
#include "core/solve/auto/auto_tuning.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// Takes from the photographs what they surely show beyond model `auto`, whatever its prior held likely.
///
/// Of a channel's lighting matrix A = U S V' every direction m of the contributions is seen by itself: the
/// photographs differ from what the answer T predicts there by z = (U_m' y) / s_m - V_m' T, of which noise
/// alone makes the variance v = sum_k (U_km / s_m)^2 var(y_k). Around a pixel R_c is the mean of z^2 / v (25
/// at most: a broken pixel is no evidence of others), summed over the directions of a channel but for its
/// first (the light all together, which every model follows). With K_c the sum of their kappa the answer
/// moves by
///   T += w sum_m z V_m,   w = max_c (1 - K_c / R_c), at least 0
/// towards the full demultiplex (James and Stein 1961; Lee's filter of 1980 between two answers): not at all
/// where T explains the photographs, all the way where the misfit is far above noise everywhere (w is scaled
/// to be 1 there). One weight for all channels and lights, so that no hue comes in that neither answer has.
/// The expected error is about the smaller one of both, as far as noise is known; kappa > 1 is for how far it
/// is not, the more the weaker the direction is seen. v includes a part of what the colours may be wrong by.
/// Captures with a direction that is hardly seen (a part of the move would change hues), sets that show
/// nothing, and pixels with flags are left alone.
///
/// `context.noise`: of the pixels' own. `colorUncertainty`: relative standard error of the light colours.
/// Changes contributions, beta, sigma and model of `set`.
void followLocalEvidence(const EstimatorContext& context, float colorUncertainty, const ShotSignal& signal,
                         const LocalEvidenceTuning& tuning, SolvedSet& set);

}  // namespace swaplight
