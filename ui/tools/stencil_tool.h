#pragma once

#include "ui/tools/picture_tool.h"

namespace swaplight {

inline constexpr Tool kStencil{
    "stencil.take", "Gobos and gradients", "Shift+T",
    "Project light through text, a shape or a gobo image, or as a gradient, by dragging.", true};

/// Lays light on through a gobo or gradient: a drag places a new one.
extern const PictureTool kStencilTool;

/// The edit of the list that is a stencil of the kind in the hand, and chosen; nullptr for none.
[[nodiscard]] const Edit* chosenStencil(const EditingContext& studio);

}  // namespace swaplight
