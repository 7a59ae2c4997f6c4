#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// One line along the bottom: what is open, what is under the mouse, how large it is shown.
void drawStatusBar(StudioContext& studio);

/// Work that goes on, over the viewer, with a button that stops it.
void drawProgress(StudioContext& studio, float centerX, float centerY);

}  // namespace swaplight
