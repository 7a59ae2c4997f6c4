#pragma once

#include <array>
#include <vector>

#include "core/simd/simd.h"
#include "core/solve/model/pixel_run.h"

namespace swaplight {

/// What a matte fit says of a run of pixels; planes as long as the run, rounded up to kMostLanes.
struct MatteRun {
  float* share[kMaxLights];  ///< beta: >= 0 (but see signedShares), sum 1
  float* reflectance[3];     ///< rho >= 0, scaled so that T = beta rho
  float* misfit;             ///< chi-square: residuals over their expected noise, squared and summed
  /// Of a light's contribution (mean of channels, averaged over the lights) over the sum of all. May be null,
  /// and shareVariance with it.
  float* variance;
  /// Of beta, mean over the lights; only the part that is noise of the pixel's own. The rest, above all what
  /// is not known of the light colours, is the same all over the picture: neighbours cannot take it away.
  float* shareVariance;
  /// Asks the fit for shares that go on below 0 where noise leads there, all else being as at 0: those,
  /// unlike shares that were cut off, have the right mean over many pixels.
  bool signedShares = false;
};

/// Constants of the capture, laid out for the kernels.
struct MattePlan {
  int lights = 0;
  int shots = 0;
  float constant = 0, linear = 0, square = 0;  ///< the noise model
  std::array<float, 3> seen{1, 1, 1};          ///< 0: a channel that no light has; nothing is asked there
  std::vector<float> color;                    ///< [k][c][i]
  std::vector<float> mean;                     ///< [c][i]: color, summed over the shots / 3 K
  std::vector<float> product;                  ///< [k][c][i <= j]: color i x color j
  std::vector<float> guess;                    ///< [k][c][i]: the ridge demultiplex, summed over channels
};

/// MatteFit::fit and MatteFit::assess.
SWAPLIGHT_DECLARE_KERNEL(fitMatte, const MattePlan& plan, const PixelRun& in, const MatteRun& out)
SWAPLIGHT_DECLARE_KERNEL(assessMatte, const MattePlan& plan, const PixelRun& in, const MatteRun& inOut)

}  // namespace swaplight
