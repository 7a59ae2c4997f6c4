#pragma once

#include "ui/tools/picture_tool.h"

namespace swaplight {

inline constexpr Tool kSelect{
    "select.take", "Select", "Shift+L",
    "Select by lasso, rectangle, ellipse, similar pixels or shadow. Edits stay inside the selection.", true};

/// Selects what edits are restricted to: Shift adds, Alt subtracts, both intersect. Draws the outline of what
/// is selected, and of what is being drawn.
extern const PictureTool kSelectionTool;

/// Another selection, as one step.
void changeSelection(EditingContext& studio, const std::string& step, Mask selection);
/// All shadows of a light.
void selectShadows(EditingContext& studio, const std::string& light);

}  // namespace swaplight
