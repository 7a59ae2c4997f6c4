#pragma once

#include "ui/control/studio_context.h"
#include "ui/kit/file_chooser.h"

namespace swaplight {

// What can be done with the view. Everything that is handed in must outlive the table.

void addViewActions(ActionTable& actions, StudioContext& studio, FileChooser& chooser);
void addCompareActions(ActionTable& actions, StudioContext& studio);

}  // namespace swaplight
