#pragma once

#include <optional>

#include "core/capture/capture_pixels.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// A capture as causes of a misfit are sought in it: the colours as told, the noise of the pixels' own.
struct CauseContext {
  EstimatorContext estimator;
  ShotSignal signal;  ///< of photographs that must live as long
};

/// `told`: the sensor's noise; else it is estimated as in a solve.
[[nodiscard]] CauseContext causeContext(const Capture& capture, const CapturePixels& photographs,
                                        const std::optional<SensorNoise>& told);

/// The noise that was asked for, or that the capture tells.
[[nodiscard]] std::optional<SensorNoise> toldNoise(const Capture& capture,
                                                   const std::optional<SensorNoise>& asked);

}  // namespace swaplight
