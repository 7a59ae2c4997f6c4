#pragma once

namespace swaplight {

inline constexpr int kMaxLights = 16;
inline constexpr int kMaxShots = 32;

/// Pixels of a run: all planes of one fit into the second-level cache. A multiple of kMostLanes.
inline constexpr int kRun = 2048;

/// Neighbouring pixels of all shots, a pointer a plane.
struct PixelRun {
  int count = 0;
  /// Linear light of the controlled lights: ambient removed, exposure still in. NaN: not to be used (clipped,
  /// broken); only estimators that say so in EstimatorInfo::masks cope with it.
  const float* signal[kMaxShots][3];
};

/// Where an estimator puts its answer; planes of the same run.
struct SolvedRun {
  float* contribution[kMaxLights][3];  ///< T >= 0
  float* beta[kMaxLights];             ///< written by writeBeta
  float* residual = nullptr;           ///< in units of the expected noise; may be null
  float* sigma = nullptr;  ///< standard error of a light's contribution (mean of channels, RMS of lights)
                           ///< over the sum of all; may be null
};

}  // namespace swaplight
