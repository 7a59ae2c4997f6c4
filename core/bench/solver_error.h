#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.h"

namespace swaplight {

/// How wrong an estimator is on a capture whose truth is known.
struct SolverError {
  std::string capture;
  std::string solver;
  double relativeRmse = 0;  ///< of the contributions, over their RMS
  double betaOverBound =
      0;                  ///< RMSE of beta over the root of its mean Cramer-Rao bound, where that is below .1
  double deltaEMean = 0;  ///< CIEDE2000 of the frame over five new lightings
  double deltaE95 = 0;    ///< its 95th percentile
  double seconds = 0;     ///< of the whole solve
};

/// Photographs the truth of a capture again with seeded noise (the capture's, or full well 20000 and read
/// noise .002), solves it with every estimator that fits, and compares. The matte bound is exceeded by gloss
/// and bounced light, which it does not know. Throws InputError where the capture has no truth.
[[nodiscard]] std::vector<SolverError> measureSolverError(const std::filesystem::path& capture, unsigned seed,
                                                          const Progress& progress = {});

}  // namespace swaplight
