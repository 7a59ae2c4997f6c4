#pragma once

#include <imgui.h>

#include "ui/control/viewer_context.h"

namespace swaplight {

/// Where each light's pools lie, over the picture: a ring as broad as the pool around its middle, how far it
/// stands out, an arrow where it goes on outside, and how many lamps each light has. `window` is the first
/// pane's, `origin` the viewer's corner on the screen.
void drawPoolOverlay(ViewerContext& studio, const ViewWindow& window, ImVec2 origin);

}  // namespace swaplight
