#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// How the brush paints.
void drawBrushPanel(EditingContext& studio);

}  // namespace swaplight
