#pragma once

#include <imgui.h>

#include "ui/control/viewer_context.h"

namespace swaplight {

/// What lies over the picture: the wipe's line, the scopes' region, the viewer's badge, legends, the names of
/// the sides. `origin` and `size` are the viewer's on the screen, `window` is that of its first pane.
void drawViewerOverlay(ViewerContext& studio, const ViewWindow& window, ImVec2 origin, ImVec2 size);

/// What is to be said about the place under the mouse, in a corner of the viewer.
void drawProbeCard(ViewerContext& studio, ImVec2 origin, ImVec2 size);

}  // namespace swaplight
