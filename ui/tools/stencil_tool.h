#pragma once

#include "ui/tools/picture_tool.h"

namespace swaplight {

/// Lays light on through a stencil or gradient: a drag places a new one.
extern const PictureTool kStencilTool;

/// The edit of the list that is a stencil of the kind in the hand, and chosen; nullptr for none.
[[nodiscard]] const Edit* chosenStencil(const EditingContext& studio);

}  // namespace swaplight
