#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/bench/solution_error.h"
#include "core/solve/model/estimator.h"

namespace swaplight {

/// How wrong an estimator is on a capture whose truth is known.
struct SolverError {
  std::string capture;
  std::string solver;
  SolutionError error;
  double seconds = 0;  ///< of the whole solve
};

/// Whether an estimator is one for these lights in these shots: the dissertation's are for two in two.
[[nodiscard]] bool fitsCapture(const EstimatorInfo& info, int lights, int shots);

/// Photographs the truth of a capture again with seeded noise (the capture's, or full well 20000 and read
/// noise .002), solves it with every estimator that fits, and compares. The matte bound is exceeded by gloss
/// and bounced light, which it does not know. Throws InputError where the capture has no truth.
[[nodiscard]] std::vector<SolverError> measureSolverError(Capture capture, unsigned seed,
                                                          const Progress& progress = {});

}  // namespace swaplight
