#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// What an edit of the list does, to be changed: its lights, what becomes of the others, the operation's
/// numbers, its curve, where it acts; or only its opacity.
void drawEditParameters(EditingContext& studio, size_t index, bool all);

}  // namespace swaplight
