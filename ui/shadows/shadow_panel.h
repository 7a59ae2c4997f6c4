#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// The page of shadows and beta: a light, its maps, where its shadows begin, and what to do about them.
void drawShadowPanel(StudioContext& studio);

}  // namespace swaplight
