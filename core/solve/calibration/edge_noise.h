#pragma once

#include "core/image/image.h"
#include "core/solve/calibration/calibration_tuning.h"
#include "core/solve/model/noise_model.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// Shots that do not lie exactly on one another (a nudged tripod, a breathing lens, what is left after
/// registering) disagree where the picture has edges, and the matte model fails there as it does at gloss.
/// A pixel's noise is therefore multiplied by 1 + d^2 e, where e is the squared gradient of the mean shot,
/// averaged over 5 x 5 pixels, over the variance of the noise (unit: 1 / pixel^2), and d is the distance that
/// the edges of this set speak of.
///
/// Returns d^2 (pixel^2): how much more the median misfit is at the strongest tenth of a sample's edges than
/// in its flatter half; 0 where that is less than half as much again or a movement too small to be one, and
/// where the set is not matte even in its flatter half, so that edges say nothing. `misfit`: chi-square of
/// the matte fit with `freedom`, a plane.
[[nodiscard]] float squaredEdgeShift(const ShotSignal& signal, const NoiseModel& noise, ImageView misfit,
                                     int freedom, const EdgeNoiseTuning& tuning = {});

/// The factor of every pixel, for `squaredShift` > 0; one plane.
void edgeNoiseFactor(const ShotSignal& signal, const NoiseModel& noise, float squaredShift, ImageSpan factor);

}  // namespace swaplight
