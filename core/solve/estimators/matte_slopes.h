#pragma once

#include <Eigen/Core>

#include "core/solve/estimators/matte_fit.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/pixel_run.h"

namespace swaplight {

/// A pixel's values of all shots and channels, [3 shot + channel], around what the matte model makes of them.
struct MatteSlopes {
  Eigen::VectorXd predicted;
  Eigen::VectorXd weight;    ///< 1 / standard deviation expected
  Eigen::VectorXd residual;  ///< weighted
  /// What the pixel's own unknowns do, weighted: rho R G B, then the shares (0 of those held at zero).
  Eigen::MatrixXd own;
};

/// Of pixel `p` of a run that was fitted. `modelError`: relative standard error of the matte model itself.
[[nodiscard]] MatteSlopes matteSlopes(const EstimatorContext& context, const PixelRun& in,
                                      const MatteRun& fit, int p, double modelError);

}  // namespace swaplight
