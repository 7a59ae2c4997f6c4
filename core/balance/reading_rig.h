#pragma once

#include "core/balance/lamp_reading.h"
#include "core/base/json_fwd.h"
#include "core/ocio/color_config.h"
#include "core/relight/rig.h"

namespace swaplight {

/// `rig` with the set's lamps as they were read: a colour of luminance 1 and stops a light; one that was off
/// is off, one whose colour is not known stays. Groups and solo are put out of the way, so that relighting
/// gives the photograph again.
[[nodiscard]] Rig rigOfReading(const ColorConfig& config, Rig rig, const SolvedSet& set,
                               const LampReading& reading);

/// A reading for programs: its lamps with colour (the set's primaries), standard errors, stops, temperature
/// where the lamp is a white, and the setting that relight takes; what is infinite is null. "rig" is
/// rigOfReading.
[[nodiscard]] Json jsonFromReading(const ColorConfig& config, const SolvedSet& set,
                                   const LampReading& reading);

}  // namespace swaplight
