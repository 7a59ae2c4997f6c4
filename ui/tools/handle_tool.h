#pragma once

#include <imgui.h>

#include "ui/control/studio_context.h"

namespace swaplight {

/// Whether the chosen edit of the list acts in a shape that has handles, and the mouse is free to drag them.
[[nodiscard]] bool handlesShown(const StudioContext& studio);

/// Drags the handles of the chosen edit's shape; with a stencil of its kind in the hand also the shape
/// itself. True where the mouse is busy with it, or would be at a click. The viewer's item was submitted
/// last.
bool handleShapeHandles(StudioContext& studio, const ViewWindow& window, ImVec2 origin);

/// The outline and the handles.
void drawShapeHandles(StudioContext& studio, const ViewWindow& window, ImVec2 origin);

}  // namespace swaplight
