#pragma once

#include "core/set/solved_set.h"
#include "core/solve/model/estimator.h"

namespace swaplight {

/// Smooths the noise that telling the lights apart left, guided by the well-exposed sum of the lights.
///
/// Only proportions are filtered: T'[i][c] = T[i][c] + (beta'[i] - beta[i]) sum_j T[j][c], so that the sum,
/// its detail and what is not matte stay. beta' is pooled (poolShares) with neighbours that are as bright and
/// do not differ by more than noise, in steps of 1, 2, 4 ... pixels up to `radius`: edges of the sum stay,
/// and those of shadows that it does not show. Only what is noise of a pixel's own counts as noise: the
/// uncertainty of the light colours is no reason to smooth. quality.sigma stays that of the solve.
void denoiseGuided(SolvedSet& set, const EstimatorContext& context, int radius);

}  // namespace swaplight
