#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// Every step that was taken; a click goes there.
void drawHistoryPanel(StudioContext& studio, bool* open);

}  // namespace swaplight
