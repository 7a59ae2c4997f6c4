#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// What can be done with shadows. What is handed in must outlive the table.
void addShadowActions(ActionTable& actions, EditingContext& studio);

}  // namespace swaplight
