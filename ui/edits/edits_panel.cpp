#include "ui/edits/edits_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <utility>

#include "ui/control/shadow_edit.h"
#include "ui/edits/brush_panel.h"
#include "ui/edits/edit_list.h"
#include "ui/edits/edit_menu.h"
#include "ui/edits/selection_panel.h"
#include "ui/edits/stencil_panel.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/shadows/shadow_panel.h"
#include "ui/tools/brush_tool.h"
#include "ui/tools/selection_tool.h"
#include "ui/tools/stencil_tool.h"

namespace swaplight {
namespace {

/// A row as wide as the panel; every button as wide as its word and its part of what is left.
void drawTools(EditingContext& studio) {
  constexpr std::array<std::pair<const char*, const char*>, 4> tools = {
      {{kBrush.id, "Brush"}, {kStencil.id, "Gobo"}, {kSelect.id, "Select"}, {"view.shadows", "Shadow"}}};
  const float gap = px(4);
  float left = ImGui::GetContentRegionAvail().x - gap * float(tools.size() - 1);
  for (const auto& [action, word] : tools) left -= ImGui::CalcTextSize(word).x;
  const float more = std::floor(left / float(tools.size()));
  for (const auto& [action, word] : tools) {
    if (action != tools.front().first) ImGui::SameLine(0, gap);
    actionTextButton(studio.actions, action, word, ImGui::CalcTextSize(word).x + more);
  }
}

}  // namespace

void drawEditsPanel(EditingContext& studio) {
  drawTools(studio);
  if (studio.tool == &kBrush) drawBrushPanel(studio);
  if (studio.tool == &kStencil) drawStencilPanel(studio);
  if (studio.tool == &kSelect) drawSelectionPanel(studio);
  if (shadowsShown(studio)) drawShadowPanel(studio);
  drawSelectionBar(studio);
  ImGui::Separator();
  ImGui::PushFont(fonts().strong);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Edits");
  ImGui::PopFont();
  tooltip("Light edits, applied from the bottom up before the lights are mixed.");
  if (studio.edits.files().reading()) {
    ImGui::SameLine();
    hint(fmt::format("reading {:.0f} %", 100 * studio.edits.files().fraction()));
  }
  const float add = px(72);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - add);
  drawAddEdit(studio, add);
  drawEditList(studio);
}

}  // namespace swaplight
