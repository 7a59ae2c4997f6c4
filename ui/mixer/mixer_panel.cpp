#include "ui/mixer/mixer_panel.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "core/relight/rig_edit.h"
#include "ui/camera_look/favourite_row.h"
#include "ui/color/light_panel.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/mixer/fader_row.h"
#include "ui/mixer/light_menu.h"
#include "ui/mixer/mixer_row.h"
#include "ui/mixer/three_point_panel.h"

namespace swaplight {
namespace {

constexpr float kLeastRows = 94;  ///< height that the rows keep, however small the window

void header(LightsContext& studio) {
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(fonts().strong);
  ImGui::TextUnformatted("Lights");
  ImGui::PopFont();
  const float side = ImGui::GetFrameHeight();
  const Rig& rig = studio.document().rig;
  ImGui::SameLine(0, px(12));
  actionTextButton(studio.actions, "view.three_point", "Three-point", px(104));
  ImGui::SameLine(ImGui::GetContentRegionMax().x - side - px(20));
  if (changedDot("##reset all", rig != unitWhiteRig(rig),
                 "Some lights differ from unit white. Click to reset all."))
    studio.actions.run("mixer.all_white");
  markItem("mixer.reset_all");
  ImGui::SameLine(0, px(6));
  if (toggleButton(kIconMore, false, kAccent, side, "Commands for all lights"))
    ImGui::OpenPopup("##mixer menu");
  markItem("mixer.menu");
  if (ImGui::BeginPopup("##mixer menu")) {
    drawMixerMenu(studio);
    ImGui::EndPopup();
  }
}

bool hasAmbient(const LightsContext& studio) {
  return studio.set() && studio.set()->solved().ambient;
}

/// The row that was drawn last, from `top` on, is scrolled into view.
void scrollToRow(float top) {
  const float bottom = ImGui::GetCursorPosY(), height = ImGui::GetWindowHeight();
  if (top < ImGui::GetScrollY())
    ImGui::SetScrollY(top);
  else if (bottom > ImGui::GetScrollY() + height)
    ImGui::SetScrollY(bottom - height);
}

void drawRows(LightsContext& studio) {
  const float whole = ImGui::GetContentRegionAvail().y;
  for (size_t i = 0; i < studio.document().rig.groups.size(); ++i) drawGroupRow(studio, i);
  const float above = ImGui::GetCursorPosY();
  const float others =
      (above > 0 ? above + px(kWideRow.gap) : 0) + (hasAmbient(studio) ? ambientRowHeight() : 0);
  const RowShape& shape = rowShape(studio.document().rig.lights.size(), whole - others);
  for (size_t i = 0; i < studio.document().rig.lights.size(); ++i) {
    const float top = ImGui::GetCursorPosY();
    drawLightRow(studio, i, shape);
    // Only when another light is chosen, as a new one is: else nobody could scroll away.
    if (studio.view.selectedLight == static_cast<int>(i) &&
        std::exchange(studio.mixer.scrolledTo, static_cast<int>(i)) != static_cast<int>(i))
      scrollToRow(top);
  }
}

}  // namespace

void drawMixerPanel(LightsContext& studio) {
  if (studio.document().rig.lights.empty()) return;
  header(studio);
  if (studio.set()) drawFavouriteRow({studio.editor, studio.shelf, studio.messages});
  const float room = ImGui::GetContentRegionAvail().y;
  const float colors = lightPanelHeight() + 2 * ImGui::GetStyle().ItemSpacing.y;
  ImGui::BeginChild("##rows", ImVec2(0, std::max(px(kLeastRows), room - colors)));
  drawRows(studio);
  if (hasAmbient(studio)) drawAmbientRow(studio);
  ImGui::EndChild();
  ImGui::Separator();
  if (studio.layout.threePoint && studio.set())
    drawThreePointPanel(studio);
  else
    drawLightPanel(studio);
}

}  // namespace swaplight
