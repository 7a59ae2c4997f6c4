#pragma once

#include <optional>

#include "core/capture/capture_pixels.h"
#include "core/set/misfit_cause.h"
#include "core/solve/causes/cause_tuning.h"

namespace swaplight {

class CauseComparison;

/// From what size on each cause would not go unsaid in these photographs: it is planted in what the matte
/// model leaves of a sample, and less and less of it, until nothing is named by the rules of misfitCauses().
/// Planted is: Ambient, white light of the same strength everywhere behind the reflectance; Tone, an exponent
/// below 1 and above; Moved, every other shot to the right, and down; Field, lamps that get redder across the
/// picture or down it, in turns. Of two ways that counts which takes more. Wrong colours are named by the
/// light that they make negative, whatever their size: of two lights they seldom make any, and may go unsaid;
/// of more nothing is said of them. Empty where misfitCauses() compares nothing.
[[nodiscard]] std::vector<CauseSight> causeSight(const CauseComparison& comparison,
                                                 const CauseTuning& tuning = {});

/// The same of a capture's photographs. `told`: the sensor's noise; else it is estimated as in a solve.
[[nodiscard]] std::vector<CauseSight> causeSight(const Capture& capture, const CapturePixels& photographs,
                                                 const std::optional<SensorNoise>& told);

}  // namespace swaplight
