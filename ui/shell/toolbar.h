#pragma once

#include "ui/actions/action_table.h"

namespace swaplight {

/// Fills the panel with buttons of files, steps and tools. The last ones, for which a low window or a large
/// scale leaves no room, stand in a list that a button opens.
void drawToolbar(const ActionTable& actions);

}  // namespace swaplight
