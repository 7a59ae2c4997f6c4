#pragma once

#include "ui/control/lights_context.h"

namespace swaplight {

/// Key, fill and back: which lights they are, their ratios, warm against cool, and looks made of them. As
/// high as the light panel, in whose place it is shown.
void drawThreePointPanel(LightsContext& studio);

}  // namespace swaplight
