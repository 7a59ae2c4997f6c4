#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// What has been done to the lights before they are mixed: the brush while it is in the hand, and the list of
/// edits.
void drawEditsPanel(EditingContext& studio);

}  // namespace swaplight
