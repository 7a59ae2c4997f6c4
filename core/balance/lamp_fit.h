#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/solve/model/noise_model.h"

namespace swaplight {

/// The pixels of a set and of one photograph of it that lamps are read from: means over 2 x 2 pixels, so that
/// the noise of the contributions, which would dilute the lamps' colours, counts a quarter (the grouping
/// estimator of Wald 1940, "The fitting of straight lines if both variables are subject to error").
struct LampBlocks {
  int lights = 0;
  bool ambient = false;  ///< the last column is the ambient light
  size_t count = 0;
  std::array<std::vector<float>, 3> value;    ///< the photograph's
  std::array<std::vector<float>, 3> columns;  ///< [block * columnCount() + column]: contributions
  std::vector<float> sigma;  ///< standard error of a contribution, relative to the sum of all
  std::vector<int> tile;     ///< part of the picture that the block lies in, 0..kLampTiles - 1

  [[nodiscard]] int columnCount() const { return lights + (ambient ? 1 : 0); }
};
inline constexpr int kLampTilesAcross = 16, kLampTilesDown = 12;
inline constexpr int kLampTiles = kLampTilesAcross * kLampTilesDown;

/// Lamps fitted to blocks. Unknowns: [channel * lights + light], and the ambient light's level last.
struct LampFit {
  Eigen::VectorXd level;       ///< >= 0
  Eigen::MatrixXd covariance;  ///< infinite on the diagonal of what no block tells
  std::vector<float> weight;   ///< of each block, 0 (left out) .. 1
  double misfit = 0;  ///< relative: 1.48 x the median of |residual| / prediction where the picture is bright
  double noise = 0;   ///< what noise alone would leave there
  std::array<double, 3> separation{};      ///< smallest over largest eigenvalue of a channel's correlations
  std::array<Eigen::VectorXd, 3> weakest;  ///< and its mixture of lights, in units of what each light gives
};

/// Per channel y = sum of l_i T_i + noise, l >= 0, by iterated weighted least squares over all channels: a
/// block's variance is that of noise and of the contributions' errors, and the square of a relative misfit
/// that the blocks themselves tell (real gels are no factor a channel); Tukey's biweight (c = 4.685 robust
/// standard deviations; Cauchy's at first, whose minimum is the same from every start) leaves out what moved
/// or is lit by something else, in all channels alike. Standard errors are those of the parts of the picture
/// against each other (cluster-robust, Liang and Zeger 1986): neighbouring residuals are not independent.
[[nodiscard]] LampFit fitLamps(const LampBlocks& blocks, const NoiseModel& noise);

}  // namespace swaplight
