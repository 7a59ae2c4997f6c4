#pragma once

#include "ui/control/viewer_context.h"
#include "ui/kit/file_chooser.h"

namespace swaplight {

// What can be done with the view. Everything that is handed in must outlive the table.

void addViewActions(ActionTable& actions, ViewerContext& studio, FileChooser& chooser);
void addCompareActions(ActionTable& actions, ViewerContext& studio);

}  // namespace swaplight
