#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// Which stencil or gradient, and what it lays on.
void drawStencilPanel(StudioContext& studio);

}  // namespace swaplight
