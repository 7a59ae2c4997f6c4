#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"

namespace swaplight {

/// How fast an estimator is, beside the memory it streams through and the published search.
struct SolverSpeed {
  std::string solver;
  int lights = 0;
  int threads = 0;
  double megapixels = 0;  ///< a second
  double limit = 0;  ///< megapixels a second of a plain stream with as many planes read and written, timed
                     ///< just before with the same threads
  double againstBruteForce =
      0;  ///< over the dissertation's search on the same threads; two lights only, else 0
};

struct SolverSpeedOptions {
  int width = 3840;
  int height = 2160;
  std::vector<int> lights = {2, 3, 4};
  std::vector<int> threads = {1, 2};
  double seconds = 0.4;  ///< spent on each figure at least; the best repetition counts
};

/// Times every estimator on random matte pixels with noise (8 megapixels by default), and `auto` on a mostly
/// matte set and on one where each light has a highlight in 15 % of the pixels. Pictures are in memory:
/// reading and writing files is not measured, nor is the quality of the answer.
[[nodiscard]] std::vector<SolverSpeed> measureSolverSpeed(const SolverSpeedOptions& options,
                                                          const Progress& progress = {});

}  // namespace swaplight
