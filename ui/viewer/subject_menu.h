#pragma once

#include "ui/control/viewer_context.h"

namespace swaplight {

/// The lines of the menu of what can be looked at, for A or B: the frame, photographs and lights; what else a
/// set has of each light in lists of their own, so that all of it fits into a low window.
void drawSubjectMenu(ViewerContext& studio, bool sideB);

}  // namespace swaplight
