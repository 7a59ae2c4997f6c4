#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// Which stencil or gradient, and what it lays on.
void drawStencilPanel(EditingContext& studio);

}  // namespace swaplight
