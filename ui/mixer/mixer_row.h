#pragma once

#include "ui/control/lights_context.h"

namespace swaplight {

/// One light's row in the mixer.
void drawLightRow(LightsContext& studio, size_t light);

}  // namespace swaplight
