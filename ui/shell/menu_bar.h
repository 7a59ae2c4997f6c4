#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// The menus: which actions, in which order.
void drawMenuBar(StudioContext& studio);

}  // namespace swaplight
