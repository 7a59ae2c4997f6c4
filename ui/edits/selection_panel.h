#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// How to select: the shape of it, and what counts as alike.
void drawSelectionPanel(StudioContext& studio);
/// What is selected: soft edge, invert, clear. Nothing where nothing is.
void drawSelectionBar(StudioContext& studio);

}  // namespace swaplight
