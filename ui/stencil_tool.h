#pragma once

#include <imgui.h>

#include "ui/studio_context.h"

namespace swaplight {

/// What the mouse does in the viewer while a stencil or gradient is in the hand: a drag places a new one, or
/// moves the chosen one where it begins on it. The viewer's item was submitted last.
void handleStencil(StudioContext& studio, const ViewWindow& window, ImVec2 origin);

/// The box or line of the stencil that is chosen.
void drawStencilFrame(StudioContext& studio, const ViewWindow& window, ImVec2 origin);

/// The edit of the list that is a stencil of the kind in the hand, and chosen; nullptr for none.
[[nodiscard]] const Edit* chosenStencil(const StudioContext& studio);

}  // namespace swaplight
