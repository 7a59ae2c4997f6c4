#pragma once

#include "core/solve/estimator.h"
#include "core/solve/solved_set.h"

namespace swaplight {

/// Smooths the noise that telling the lights apart left, guided by the well-exposed sum of the lights.
///
/// Only proportions are filtered: T'[i][c] = T[i][c] + (beta'[i] - beta[i]) sum_j T[j][c], so that the sum,
/// its detail and what is not matte stay. beta' is a guided filter (He, Sun and Tang 2010; guide: cube root
/// of the sum) as a weighted one: pixels count by the inverse variance of their beta. A shadow's edge that
/// the sum does not show would be lost in it, so that beta stays wherever it differs from beta', in the mean
/// over a small window beside the pixel, by as much as its noise.
/// Only what is noise of a pixel's own counts as noise: the uncertainty of the light colours is no reason to
/// smooth. `radius`: pixels, 1 and more. quality.sigma stays that of the solve.
void denoiseGuided(SolvedSet& set, const EstimatorContext& context, int radius);

}  // namespace swaplight
