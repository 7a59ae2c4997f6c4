#pragma once

#include "ui/control/viewer_context.h"
#include "ui/kit/file_chooser.h"

namespace swaplight {

/// The camera look: its filters in their order, the parameters of the one in focus, and all filters that
/// there are.
void drawCameraLookPanel(ViewerContext& studio, FileChooser& chooser);

}  // namespace swaplight
