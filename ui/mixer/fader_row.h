#pragma once

#include "ui/control/lights_context.h"

namespace swaplight {

/// The fader of a group of lights, as a row of the mixer.
void drawGroupRow(LightsContext& studio, size_t group);
/// The fader of what no light explains.
void drawAmbientRow(LightsContext& studio);

}  // namespace swaplight
