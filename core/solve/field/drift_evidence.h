#pragma once

#include <Eigen/Core>

#include "core/solve/field/drift_sample.h"

namespace swaplight {

/// What one way of looking at photographs says of LampDrift's unknowns: a normal likelihood, as its
/// information matrix, and that times the estimate. A change to the drift that the sample was fitted with.
struct DriftEvidence {
  Eigen::MatrixXd information;
  Eigen::VectorXd pull;
};

/// By the matte model: lamps of different drift leave contributions that are no multiples of each other. Says
/// nothing of a drift that all lamps share, which the reflectance takes up. The colours as told may be wrong
/// (marginalised).
[[nodiscard]] DriftEvidence matteEvidence(const DriftSample& sample, const FieldTuning& tuning);

/// By surfaces of one colour (Land and McCann 1971): from a pixel to its neighbour the reflectance changes by
/// nothing or by an edge, which are outliers, or by what the lamps' drift makes of it, sum_i beta_i log d_i.
/// The set's own colours may go over the picture, too (marginalised).
[[nodiscard]] DriftEvidence surfaceEvidence(const DriftSample& sample, const FieldTuning& tuning);

}  // namespace swaplight
