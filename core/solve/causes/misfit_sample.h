#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/solve/causes/cause_tuning.h"
#include "core/solve/estimators/matte_fit.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/packed_run.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// What the matte model leaves of one pixel, and what can be seen of any other cause there. Values are those
/// of all shots and channels, [3 shot + channel].
struct PixelMisfit {
  int x = 0, y = 0;            ///< in the picture
  Eigen::VectorXd values;      ///< as they were photographed
  Eigen::VectorXd predicted;   ///< by the matte model
  Eigen::VectorXd weight;      ///< 1 / standard deviation expected
  std::vector<float> share;    ///< beta, [light]
  float reflectance[3] = {};   ///< T = beta rho
  Eigen::VectorXd residual;    ///< weighted, in the directions that the pixel's own unknowns leave free
  Eigen::MatrixXd directions;  ///< values x those directions, orthonormal

  /// How a small change of the values shows in `residual`; a column each.
  [[nodiscard]] Eigen::MatrixXd visible(const Eigen::MatrixXd& change) const {
    return directions.transpose() * (weight.asDiagonal() * change);
  }
};

/// Pixels of a set, and where each was taken.
struct PlacedPixels {
  PackedRun values;
  std::vector<size_t> places;
};

/// About `count` pixels that are neither dark nor flagged, spread evenly over the set.
[[nodiscard]] PlacedPixels brightPixels(const ShotSignal& signal, int shots, int count,
                                        const CauseTuning& tuning);

/// What the matte model leaves of pixel `p` of a run that was fitted. `modelError`: CauseTuning's. The place
/// is for the caller to say.
[[nodiscard]] PixelMisfit misfitOf(const EstimatorContext& context, const PixelRun& in, const MatteRun& fit,
                                   int p, double modelError);

/// What the matte model leaves of pixels, less those of which it leaves nothing.
[[nodiscard]] std::vector<PixelMisfit> misfitSample(const EstimatorContext& context, const ShotSignal& signal,
                                                    const PlacedPixels& pixels, const CauseTuning& tuning);

/// What it leaves of about `count` pixels that are neither dark nor flagged, spread evenly over
/// the set.
[[nodiscard]] std::vector<PixelMisfit> misfitSample(const EstimatorContext& context, const ShotSignal& signal,
                                                    int count, const CauseTuning& tuning);

}  // namespace swaplight
