#pragma once

#include "ui/control/lights_context.h"

namespace swaplight {

/// A row for every light, in the capture's order, and below them the colour of the chosen one.
void drawMixerPanel(LightsContext& studio);

}  // namespace swaplight
