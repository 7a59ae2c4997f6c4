#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// How the brush paints.
void drawBrushPanel(StudioContext& studio);

}  // namespace swaplight
