#pragma once

#include <vector>

#include "ui/control/viewer_context.h"
#include "ui/shell/panel_info.h"

namespace swaplight {

/// The menus: which actions, in which order.
void drawMenuBar(ViewerContext& studio, const std::vector<PanelInfo>& panels);

}  // namespace swaplight
