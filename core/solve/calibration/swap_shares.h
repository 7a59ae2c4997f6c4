#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/solve/calibration/calibration_tuning.h"
#include "core/solve/calibration/swapped_evening.h"
#include "core/solve/model/noise_model.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// A few neighbouring pixels of the two photographs of a swap.
struct SwapContrast {
  Eigen::Vector3d value;      ///< (y1 - y2) / (y1 + y2) a channel, evened
  Eigen::Vector3d precision;  ///< one over its variance: by noise, and by what no noise explains
  std::array<int, 2> kind;    ///< of surface: red and blue of ln(y1 + y2) less its mean, in whole steps
};

/// Of a sample of the set; without what noise hides.
[[nodiscard]] std::vector<SwapContrast> swapContrasts(const ShotSignal& signal, const SwappedColor& swapped,
                                                      int shots, const Evening& evening,
                                                      const NoiseModel& noise,
                                                      const SwappedColorTuning& tuning);

/// The contrasts as shares (2 beta - 1) times one direction: a factorisation of rank one, by maximum
/// likelihood in a robust fit. What does not fit (glossy, moved) counts less: 1 / (1 + chi-square)^2.
struct SwapShares {
  Eigen::Vector3d direction;  ///< of length 1
  std::vector<double> share;  ///< of each contrast along it: (2 beta - 1) |d|
  std::vector<double> error;  ///< of it, by what the fit leaves in the other directions
};
[[nodiscard]] SwapShares swapShares(const std::vector<SwapContrast>& contrasts,
                                    const SwappedColorTuning& tuning);

/// |d|, if somewhere one lamp alone lights the set: the largest shares, noise allowed for, of most kinds of
/// surface. Not of the whole set: a camera's channels are broad, so that one gel's factor differs from
/// surface to surface, and a single surface of a deep colour would decide (a blue mug under a warm gel and
/// none: 1.7 times the contrast of a white one).
[[nodiscard]] double swapScale(const std::vector<SwapContrast>& contrasts, const SwapShares& shares,
                               const SwappedColorTuning& tuning);

}  // namespace swaplight
