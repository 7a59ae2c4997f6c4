#pragma once

#include "core/solve/calibration/calibration_tuning.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// The noise of the pixels' own where nobody told it, from `context.noise`, the spatial estimate.
///
/// That one (estimateSensorNoise) takes texture for noise. What the matte model leaves has no texture,
/// shading or relief in it, and second differences of that over neighbouring pixels hold no error that is
/// smooth: gloss, bounced light, wrong colours. The quietest fifth of the blocks, in bins of brightness,
/// gives the noise; in no bin it is above the spatial estimate (both are too large at worst), nor below
/// `least`, the quantisation of the files. Fine relief, gloss and bounced light only add to a bin, and a
/// camera's noise is constant + linear (photon transfer): what lies below all bins is its noise
/// (varianceBelow). Where means of 2 x 2 pixels vary more than independent noise would (JPEG, demosaicing),
/// the noise of a pixel is raised by that. Returns the spatial estimate where the fit leaves no freedom or
/// the set is too small.
[[nodiscard]] NoiseModel residualNoise(const EstimatorContext& context, const NoiseModel& least,
                                       const ShotSignal& signal, const ResidualNoiseTuning& tuning = {});

/// What a pixel is held against: `own`, and of all that `calibrated` (calibratedNoise) has beyond it the part
/// (0..1) that is an error of the model, not of the set.
[[nodiscard]] NoiseModel withModelError(const NoiseModel& own, const NoiseModel& calibrated, float part);

/// The least that photographs may have: that of their files' codes.
[[nodiscard]] NoiseModel codingNoise(const CapturePixels& photographs);

}  // namespace swaplight
