#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/solve/field/field_tuning.h"
#include "core/solve/field/lamp_drift.h"

namespace swaplight {

/// How the lamps' colours drift over the picture, as the photographs themselves show it (docs/theory.md,
/// Lamps that are not even): maximum a posteriori of the two evidences of drift_evidence.h and a normal prior
/// at zero, Gauss and Newton's steps, on photographs averaged down. Nothing where misfitCauses() does not
/// name drifting lamps first: then an even lamp is the better guess. Throws InputError where a light's colour
/// is unknown, Stopped. `noise`: the sensor's, if it is told otherwise than by the capture.
[[nodiscard]] std::optional<LampDrift> findDrift(const Capture& capture, const CapturePixels& photographs,
                                                 const std::optional<SensorNoise>& noise = {},
                                                 const Progress& progress = {},
                                                 const FieldTuning& tuning = {});

}  // namespace swaplight
