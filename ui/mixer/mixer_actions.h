#pragma once

#include "ui/control/lights_context.h"
#include "ui/kit/file_chooser.h"

namespace swaplight {

// What can be done with lights and looks. Everything that is handed in must outlive the table.

void addLightActions(ActionTable& actions, LightsContext& studio, FileChooser& chooser);
void addLookActions(ActionTable& actions, LightsContext& studio);

}  // namespace swaplight
