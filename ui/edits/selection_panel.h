#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// How to select: the shape of it, and what counts as alike.
void drawSelectionPanel(EditingContext& studio);
/// What is selected: soft edge, invert, clear. Where nothing is: greyed with the tool in hand, else nothing.
/// What stands below does not move when something gets selected.
void drawSelectionBar(EditingContext& studio);

}  // namespace swaplight
