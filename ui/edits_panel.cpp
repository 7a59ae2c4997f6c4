#include "ui/edits_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include <cmath>

#include "ui/brush_panel.h"
#include "ui/edit_list.h"
#include "ui/edit_menu.h"
#include "ui/menu_bar.h"
#include "ui/selection_panel.h"
#include "ui/shadow_edit.h"
#include "ui/shadow_panel.h"
#include "ui/stencil_panel.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace swaplight {

void drawEditsPanel(StudioContext& studio) {
  const float side = std::floor((ImGui::GetContentRegionAvail().x - 3 * px(4)) / 4);
  actionTextButton(studio.actions, "brush.take", "Brush", side);
  ImGui::SameLine(0, px(4));
  actionTextButton(studio.actions, "stencil.take", "Stencil", side);
  ImGui::SameLine(0, px(4));
  actionTextButton(studio.actions, "select.take", "Select", side);
  ImGui::SameLine(0, px(4));
  actionTextButton(studio.actions, "view.shadows", "Shadow", side);
  if (studio.tool == Tool::Brush) drawBrushPanel(studio);
  if (studio.tool == Tool::Stencil) drawStencilPanel(studio);
  if (studio.tool == Tool::Select) drawSelectionPanel(studio);
  if (shadowsShown(studio)) drawShadowPanel(studio);
  drawSelectionBar(studio);
  ImGui::Separator();
  ImGui::PushFont(fonts().strong);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Edits");
  ImGui::PopFont();
  tooltip("What is done to the lights before they are mixed, from the bottom up.");
  const float add = px(72);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - add);
  drawAddEdit(studio, add);
  drawEditList(studio);
}

}  // namespace swaplight
