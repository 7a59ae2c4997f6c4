#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// The fader of a group of lights, as a row of the mixer.
void drawGroupRow(StudioContext& studio, size_t group);
/// The fader of what no light explains.
void drawAmbientRow(StudioContext& studio);

}  // namespace swaplight
