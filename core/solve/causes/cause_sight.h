#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/set/misfit_cause.h"
#include "core/solve/causes/cause_tuning.h"

namespace swaplight {

class CauseComparison;

/// From what size on some causes would not go unsaid in these photographs, of which nothing is said: the
/// cause is planted in the values of a sample of pixels, strong, and less and less of it, and the matte model
/// fitted to them again, until nothing is named by the rules of misfitCauses(). Lights that hardly reach a
/// pixel take up of it what they would take up of what is really there. What the sample seems to have of the
/// cause in that sense (more light, not less) is taken off first: it may be what goes unsaid. Planted is:
/// Ambient, white light of the same strength everywhere behind the reflectance; Tone, an exponent below 1,
/// and one above, of which that counts which takes more; Field, lamps that get redder and less blue across
/// the picture or down it, in turns. What a camera that moved would do is that of the photographs as they
/// are. It seldom goes unsaid, and is left out. Wrong colours are named by negative light: two shots seldom
/// have any, fewer shots than lights do not tell, and there they may go unsaid. Empty where misfitCauses()
/// compares nothing, or names a cause.
[[nodiscard]] std::vector<CauseSight> causeSight(const CauseComparison& comparison,
                                                 const CauseTuning& tuning = {},
                                                 const Progress& progress = {});

/// The same of a capture's photographs, which lie around full scale 1. `told`: the sensor's noise; else it is
/// estimated as in a solve.
[[nodiscard]] std::vector<CauseSight> causeSight(const Capture& capture, const CapturePixels& photographs,
                                                 const std::optional<SensorNoise>& told,
                                                 const Progress& progress = {});

}  // namespace swaplight
