#pragma once

#include "ui/control/export_controller.h"
#include "ui/control/set_controller.h"

namespace swaplight {

// Work that goes on, over the viewer, each with a button that stops it.

/// A set that is being read or solved; around a place of the screen.
void drawSetProgress(SetController& sets, float centerX, float centerY);
/// What is being exported, in the lower right corner of a rectangle of the screen.
void drawExportProgress(ExportController& exports, float right, float bottom);

}  // namespace swaplight
