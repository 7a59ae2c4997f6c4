#pragma once

#include "core/solve/calibration/calibration_tuning.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// Holds an estimated noise model against what the matte fit leaves. Glare, black level and colours that are
/// not quite right make the spatial estimate too small as a yardstick for "does the matte model explain this
/// pixel". In bins of brightness the median chi-square over its expectation says by what factor; constant +
/// linear y + square y^2 is fitted through the bins again. More than 10 is gloss and bounced light;
/// less than 1 is an accident, unless all bins say so: then there was nothing flat to measure noise on.
/// Returns the model as it is where the fit leaves no freedom.
[[nodiscard]] NoiseModel calibratedNoise(const EstimatorContext& context, const ShotSignal& signal,
                                         const NoiseCalibrationTuning& tuning = {});

}  // namespace swaplight
