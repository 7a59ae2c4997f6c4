#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// One line along the bottom: what is open, what is under the mouse, how large it is shown.
void drawStatusBar(StudioContext& studio);

}  // namespace swaplight
