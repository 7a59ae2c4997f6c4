#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// Where an edit of the list acts: everywhere, in a rectangle, in shadows; what was painted or drawn is
/// named.
void drawEditPlace(StudioContext& studio, size_t index);

}  // namespace swaplight
