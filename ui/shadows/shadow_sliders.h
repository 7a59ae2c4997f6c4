#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// What to do about the chosen shadow, or all shadows of a light: each slider is one edit of the list.
void drawShadowSliders(EditingContext& studio, const std::string& light);

}  // namespace swaplight
