#pragma once

#include <vector>

#include "core/simd/simd.h"
#include "core/solve/estimators/matte_kernel.h"

namespace swaplight {

/// Constants of the capture, laid out for the kernel.
struct GlossPlan {
  int lights = 0, shots = 0;
  float constant = 0, linear = 0, square = 0;  ///< the noise model
  std::vector<float> color;                    ///< [k][c][i]
};

/// GlossFit for a run whose matte fit is given; planes padded to kMostLanes. Writes contributions, chi-square
/// into `out.residual` and variance into `out.sigma` (neither null).
SWAPLIGHT_DECLARE_KERNEL(fitGloss, const GlossPlan& plan, const PixelRun& in, const MatteRun& matte,
                         const SolvedRun& out)

}  // namespace swaplight
