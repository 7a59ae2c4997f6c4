#pragma once

#include "ui/control/lights_context.h"
#include "ui/kit/file_chooser.h"

namespace swaplight {

class LampReader;

// What can be done with lights and looks. Everything that is handed in must outlive the table.

void addLightActions(ActionTable& actions, LightsContext& studio, FileChooser& chooser);
/// White balance of the lights, and reading them from a photograph.
void addBalanceActions(ActionTable& actions, LightsContext& studio, LampReader& lamps, FileChooser& chooser);
void addLookActions(ActionTable& actions, LightsContext& studio);

}  // namespace swaplight
