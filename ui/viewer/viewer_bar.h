#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// The controls above the picture: what is shown, compared with what, and through which view.
void drawViewerBar(StudioContext& studio);

/// The lines of the menu of displays and views.
void drawDisplayMenu(StudioContext& studio);
/// The lines of the menu of subjects, for A or B.
void drawSubjectMenu(StudioContext& studio, bool sideB);

}  // namespace swaplight
