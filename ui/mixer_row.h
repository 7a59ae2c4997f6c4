#pragma once

#include "ui/studio_context.h"

namespace swaplight {

/// One light's row in the mixer.
void drawLightRow(StudioContext& studio, size_t light);
/// The fader of a group of lights.
void drawGroupRow(StudioContext& studio, size_t group);
/// What no light explains.
void drawAmbientRow(StudioContext& studio);

}  // namespace swaplight
