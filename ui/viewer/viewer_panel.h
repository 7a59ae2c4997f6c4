#pragma once

#include "ui/control/viewer_context.h"

namespace swaplight {

/// The picture: pan, zoom, what is shown of it. Fills the current ImGui window's content region.
void drawViewerPanel(ViewerContext& studio);

}  // namespace swaplight
