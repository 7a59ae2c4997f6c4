#pragma once

#include <imgui.h>

#include "ui/control/editing_context.h"

namespace swaplight {

/// The outlines of the chosen light's shadows over the picture, hatching where they cannot be told, the
/// person's marks, and a legend. `window` is the first pane's, `origin` and `size` are the viewer's on the
/// screen.
void drawShadowOverlay(EditingContext& studio, const ViewWindow& window, ImVec2 origin, ImVec2 size);

}  // namespace swaplight
