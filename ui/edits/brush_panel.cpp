#include "ui/edits/brush_panel.h"

#include <imgui.h>

#include "ui/edits/paint_modes.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/panel_controls.h"
#include "ui/kit/widgets.h"
#include "ui/tools/brush_tool.h"

namespace swaplight {

void drawBrushPanel(EditingContext& studio) {
  BrushState& brush = studio.editing.brush;
  drawPaintModes(studio);
  float size = 2 * brushRadius(studio);
  if (labelledSlider("Size", "brush.size", &size, 2, 2000, "%.0f px",
                     "Image pixels.  ([ and ], Ctrl + wheel)", kLogarithmic))
    setBrushRadius(studio, size / 2);
  percentSlider("Hardness", "brush.hardness", &brush.hardness, 100,
                "Hardness of the brush's edge.  (Shift + [ and ])");
  percentSlider("Opacity", "brush.opacity", &brush.opacity, 100,
                "The most a stroke builds up to, however often it crosses itself.  (1 to 9, 0 is 100 %)");
  percentSlider("Flow", "brush.flow", &brush.flow, 100, "How fast a stroke builds up to its opacity.");
  actionTextButton(studio.actions, "brush.edges", "Follow edges", ImGui::GetContentRegionAvail().x);
  actionTextButton(studio.actions, "brush.erase", "Erase", ImGui::GetContentRegionAvail().x);
  actionTextButton(studio.actions, "brush.new_light", "New light by painting",
                   ImGui::GetContentRegionAvail().x);
  hint("Shift + click: a straight line");
}

}  // namespace swaplight
