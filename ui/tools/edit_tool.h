#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// Takes a tool that makes edits into the hand, and shows their panel; again: puts it away.
void takeEditTool(EditingContext& studio, Tool tool);

}  // namespace swaplight
