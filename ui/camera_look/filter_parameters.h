#pragma once

#include "ui/control/viewer_context.h"
#include "ui/kit/file_chooser.h"

namespace swaplight {

/// What the filter in focus can be set to, as its header says.
void drawFilterParameters(ViewerContext& studio, size_t index, FileChooser& chooser);

}  // namespace swaplight
