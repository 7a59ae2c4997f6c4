#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// Where an edit of the list acts: everywhere, in a rectangle, in shadows; what was painted or drawn is
/// named.
void drawEditPlace(EditingContext& studio, size_t index);

}  // namespace swaplight
