#include "ui/edits_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include "ui/brush_panel.h"
#include "ui/edit_list.h"
#include "ui/menu_bar.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace swaplight {

void drawEditsPanel(StudioContext& studio) {
  if (studio.tool == Tool::Brush) {
    drawBrushPanel(studio);
    ImGui::Separator();
  }
  ImGui::PushFont(fonts().strong);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Edits");
  ImGui::PopFont();
  tooltip("What is done to the lights before they are mixed, from the bottom up.");
  drawEditList(studio);
}

}  // namespace swaplight
