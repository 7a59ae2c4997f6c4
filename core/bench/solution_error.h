#pragma once

#include <vector>

#include "core/set/solved_set.h"
#include "core/solve/model/lighting_matrix.h"
#include "core/solve/model/noise_model.h"

namespace swaplight {

/// A truth, and how well its pixels could be known if they were matte.
struct BoundedTruth {
  SolvedSet set;
  std::vector<double> betaBound;  ///< of each pixel; see MatteBound
  /// RMS of the bound of T over the RMS of T; a pixel's error counts as no more than its own light.
  double relativeBound = 0;

  /// `clip`: full scale of the shots, or infinity.
  BoundedTruth(SolvedSet truth, const LightingMatrix& lighting, const NoiseModel& noise, float clip);
};

/// How wrong a solved set is.
struct SolutionError {
  double relativeRmse = 0;  ///< of the contributions, over their RMS
  /// RMSE of beta over the root of its mean Cramer-Rao bound, where that is below .1; 0 where it is nowhere.
  double betaOverBound = 0;
  double deltaEMean = 0;      ///< CIEDE2000 of the frame over five new lightings, the brightest 0.5 % at .9
  double deltaE95 = 0;        ///< its 95th percentile
  double withinTwoSigma = 0;  ///< fraction of lit pixels and lights whose error is within 2 quality.sigma
  size_t notFinite = 0;       ///< values of contributions, beta and quality
};

[[nodiscard]] SolutionError compareSolution(const SolvedSet& set, const BoundedTruth& truth);

}  // namespace swaplight
