#include "ui/edits_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include <cmath>

#include "ui/brush_panel.h"
#include "ui/edit_list.h"
#include "ui/menu_bar.h"
#include "ui/selection_panel.h"
#include "ui/stencil_panel.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace swaplight {

void drawEditsPanel(StudioContext& studio) {
  const float side = std::floor((ImGui::GetContentRegionAvail().x - 2 * px(4)) / 3);
  actionTextButton(studio.actions, "brush.take", "Brush", side);
  ImGui::SameLine(0, px(4));
  actionTextButton(studio.actions, "stencil.take", "Stencil", side);
  ImGui::SameLine(0, px(4));
  actionTextButton(studio.actions, "select.take", "Select", side);
  if (studio.tool == Tool::Brush) drawBrushPanel(studio);
  if (studio.tool == Tool::Stencil) drawStencilPanel(studio);
  if (studio.tool == Tool::Select) drawSelectionPanel(studio);
  drawSelectionBar(studio);
  ImGui::Separator();
  ImGui::PushFont(fonts().strong);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Edits");
  ImGui::PopFont();
  tooltip("What is done to the lights before they are mixed, from the bottom up.");
  drawEditList(studio);
}

}  // namespace swaplight
