#pragma once

#include "ui/tools/picture_tool.h"

namespace swaplight {

/// Whether the chosen edit of the list acts in a shape that has handles, and the mouse is free to drag them.
[[nodiscard]] bool handlesShown(const EditingContext& studio);

/// Drags the handles of the chosen edit's shape; with a stencil of its kind in the hand also the shape
/// itself. Draws outline and handles.
extern const PictureTool kHandleTool;

}  // namespace swaplight
