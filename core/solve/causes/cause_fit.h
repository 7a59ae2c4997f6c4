#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/solve/causes/misfit_sample.h"

namespace swaplight {

/// The residuals of a sample's pixels (PixelMisfit::residual), one below the other.
struct MisfitRows {
  Eigen::VectorXd residual;
  std::vector<Eigen::Index> first;  ///< row of each pixel, and one past the last
};

[[nodiscard]] MisfitRows misfitRows(const std::vector<PixelMisfit>& sample);

/// Pixels that follow each other in a sample.
struct PixelSpan {
  int begin = 0, end = 0;
};

/// A cause's unknowns, and how much misfit they leave.
struct CauseFit {
  Eigen::VectorXd unknowns;
  double squaredScale = 1;  ///< of the residuals, in units of what is expected
};

/// Fits a cause to pixels: residuals are of Student's t around it (Lange, Little and Taylor 1989: iteratively
/// reweighted least squares), their scale with it; the unknowns have a normal prior around 0. `slopes`: what
/// the unknowns do to the rows (PixelMisfit::visible), a column each; no column: no cause at all.
[[nodiscard]] CauseFit fitCause(const MisfitRows& rows, const Eigen::MatrixXd& slopes,
                                const PixelSpan& pixels, double prior, const CauseTuning& tuning);

/// The logarithm of each pixel's likelihood, but for what is the same for all causes.
[[nodiscard]] std::vector<double> logLikelihoods(const MisfitRows& rows, const Eigen::MatrixXd& slopes,
                                                 const PixelSpan& pixels, const CauseFit& fit,
                                                 const CauseTuning& tuning);

}  // namespace swaplight
