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
/// alone makes the variance v = sum_k (U_km / s_m)^2 var(y_k). Around a pixel the mean of z^2 is D, that of v
/// is N, and the answer moves along the direction by the part of z that noise does not explain,
///   T += w z V_m,   w = 1 - kappa N / D, at least 0
/// (James and Stein 1961; the local Wiener filter of Lee 1980): nowhere where T explains the photographs, all
/// the way to the full demultiplex where the misfit is far above noise. So its expected error is about the
/// smaller one of both, as far as noise is known; kappa > 1 is for how far it is not, the more the weaker the
/// direction is seen. v includes a part of what the colours may be wrong by. Directions that are hardly seen,
/// those of which the whole set shows nothing, and pixels with flags are left alone.
///
/// `context.noise`: of the pixels' own. `colorUncertainty`: relative standard error of the light colours.
/// Changes contributions, beta, sigma and model of `set`.
void followLocalEvidence(const EstimatorContext& context, float colorUncertainty, const ShotSignal& signal,
                         const LocalEvidenceTuning& tuning, SolvedSet& set);

}  // namespace swaplight
