#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// Which light is laid on, what happens to it, how much, and what becomes of the other lights: for the brush
/// as for stencils.
void drawPaintModes(EditingContext& studio);

}  // namespace swaplight
