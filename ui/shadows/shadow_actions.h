#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// What can be done with shadows. What is handed in must outlive the table.
void addShadowActions(ActionTable& actions, StudioContext& studio);

}  // namespace swaplight
