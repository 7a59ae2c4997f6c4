#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// How to select: the shape of it, and what counts as alike.
void drawSelectionPanel(EditingContext& studio);
/// What is selected: soft edge, invert, clear. Nothing where nothing is.
void drawSelectionBar(EditingContext& studio);

}  // namespace swaplight
