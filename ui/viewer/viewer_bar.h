#pragma once

#include "ui/control/viewer_context.h"

namespace swaplight {

/// The controls above the picture: what is shown, compared with what, and through which view.
void drawViewerBar(ViewerContext& studio);

/// The lines of the menu of displays and views.
void drawDisplayMenu(ViewerContext& studio);

}  // namespace swaplight
