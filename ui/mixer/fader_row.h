#pragma once

#include "ui/control/lights_context.h"

namespace swaplight {

/// The fader of a group of lights, as a row of the mixer.
void drawGroupRow(LightsContext& studio, size_t group);
/// The height of the row of what no light explains, with the gap above it, in pixels.
[[nodiscard]] float ambientRowHeight();
/// The fader of what no light explains.
void drawAmbientRow(LightsContext& studio);

}  // namespace swaplight
