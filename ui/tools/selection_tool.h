#pragma once

#include <imgui.h>

#include "ui/control/studio_context.h"

namespace swaplight {

/// What the mouse does in the viewer while something is being selected; the viewer's item was submitted last.
/// `origin` is the corner of the pane under the mouse. Shift adds, Alt subtracts, both intersect.
void handleSelection(StudioContext& studio, const ViewWindow& window, ImVec2 origin);

/// The outline of what is selected, and of what is being drawn.
void drawSelection(StudioContext& studio, const ViewWindow& window, ImVec2 origin);

/// Another selection, as one step.
void changeSelection(StudioContext& studio, const std::string& step, Mask selection);
/// All shadows of a light.
void selectShadows(StudioContext& studio, const std::string& light);

}  // namespace swaplight
