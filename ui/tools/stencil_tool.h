#pragma once

#include <imgui.h>

#include "ui/control/studio_context.h"

namespace swaplight {

/// What the mouse does in the viewer while a stencil or gradient is in the hand, where it takes hold of
/// nothing (handle_tool.h): a drag places a new one. The viewer's item was submitted last.
void handleStencil(StudioContext& studio, const ViewWindow& window, ImVec2 origin);

/// The edit of the list that is a stencil of the kind in the hand, and chosen; nullptr for none.
[[nodiscard]] const Edit* chosenStencil(const StudioContext& studio);

}  // namespace swaplight
