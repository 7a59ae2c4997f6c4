#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// The page of shadows and beta: a light, its maps, where its shadows begin, and what to do about them.
void drawShadowPanel(EditingContext& studio);

}  // namespace swaplight
