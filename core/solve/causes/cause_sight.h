#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/set/misfit_cause.h"
#include "core/solve/causes/cause_tuning.h"

namespace swaplight {

class CauseComparison;

/// From what size on some causes would not go unsaid in these photographs, of which nothing is said: what the
/// cause explains is taken off what the matte model leaves of a sample (it may be what goes unsaid), and it
/// is planted there, strong, and less and less of it, until nothing is named by the rules of misfitCauses().
/// Planted is: Ambient, white light of the same strength everywhere behind the reflectance; Tone, an exponent
/// below 1, and one above, of which that counts which takes more; Field, lamps that get redder and less blue
/// across the picture or down it, in turns. Negative light, by which the rules know some curves and drifts,
/// is that of the photographs as they are. A camera that moved seldom goes unsaid, and is left out. Wrong
/// colours are named by negative light: two shots of two lights seldom have any, and they may go unsaid.
/// Empty where misfitCauses() compares nothing, or names a cause; and with more than two lights, of which
/// those that do not reach a pixel take up what is really there, so that more goes unsaid than is planted.
[[nodiscard]] std::vector<CauseSight> causeSight(const CauseComparison& comparison,
                                                 const CauseTuning& tuning = {},
                                                 const Progress& progress = {});

/// The same of a capture's photographs, which lie around full scale 1. `told`: the sensor's noise; else it is
/// estimated as in a solve.
[[nodiscard]] std::vector<CauseSight> causeSight(const Capture& capture, const CapturePixels& photographs,
                                                 const std::optional<SensorNoise>& told,
                                                 const Progress& progress = {});

}  // namespace swaplight
