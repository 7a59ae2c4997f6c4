#pragma once

#include "ui/control/studio_context.h"
#include "ui/kit/file_chooser.h"

namespace swaplight {

// What can be done with lights and looks. Everything that is handed in must outlive the table.

void addLightActions(ActionTable& actions, StudioContext& studio, FileChooser& chooser);
void addLookActions(ActionTable& actions, StudioContext& studio);

}  // namespace swaplight
