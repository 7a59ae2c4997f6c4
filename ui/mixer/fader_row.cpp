#include "ui/mixer/fader_row.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/control/light_edit.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/widgets.h"
#include "ui/mixer/level_field.h"
#include "ui/mixer/level_slider.h"
#include "ui/mixer/light_menu.h"
#include "ui/mixer/mixer_card.h"

namespace swaplight {
namespace {

constexpr float kHeight = 48;
constexpr float kNameWidth = 94;
constexpr float kFaderGap = 6;

void editGroup(LightsContext& studio, size_t index, const std::string& what, float stops, bool on) {
  Rig rig = studio.document().rig;
  rig.groups[index].stops = stops;
  rig.groups[index].on = on;
  editRig(studio, rig.groups[index].name + ": " + what, rig);
}

void groupName(LightsContext& studio, const LightGroup& group, const MixerCard& card) {
  const ImVec2 clip = ImGui::GetCursorScreenPos();
  ImGui::PushClipRect(clip, ImVec2(clip.x + px(kNameWidth), clip.y + card.size().y), true);
  ImGui::PushFont(fonts().strong);
  ImGui::TextUnformatted(
      cutToWidth(fmt::format("{}  {}", kIconLayers, group.name), px(kNameWidth - kFaderGap)).c_str());
  ImGui::PopFont();
  ImGui::PopClipRect();
  markItem({"mixer.group.", group.name});
  tooltip("A group of lights. Right-click to ungroup.");
  if (!ImGui::BeginPopupContextItem("##group menu")) return;
  if (ImGui::MenuItem("Ungroup"))
    editRig(studio, group.name + ": dissolve", withoutGroup(studio.document().rig, group.name));
  markItem("group_menu.dissolve");
  ImGui::EndPopup();
}

void previewGroup(LightsContext& studio, size_t index, double level) {
  Document next = studio.document();
  LightGroup& group = next.rig.groups[index];
  group.stops = static_cast<float>(std::log2(level));
  studio.editor.preview(group.name + ": fader", std::move(next));
}

void groupLevel(LightsContext& studio, size_t index, float width) {
  const LightGroup group = studio.document().rig.groups[index];
  const std::string mark = "mixer.group." + group.name;
  const double level = std::exp2(static_cast<double>(group.stops));
  float stops = group.stops;
  const LevelSliding sliding = levelSlider("##stops", &stops, kStopsRange, width);
  markItem({mark, ".stops"});
  tooltip("Level of the group in stops. Shift drags finely, wheel and arrow keys step, double-click resets.");
  keepNudges(studio.mixer, mark, sliding);
  if (sliding.toType) typeLevel(studio.mixer, mark, level);
  if (sliding.changed) previewGroup(studio, index, std::exp2(static_cast<double>(stops)));
  ImGui::SameLine(0, px(kFaderGap));
  const auto change = levelField(studio, mark, level);
  if (change && change->level == 0)
    editGroup(studio, index, "out", group.stops, false);
  else if (change && change->typed)
    editGroup(studio, index, "fader", static_cast<float>(std::log2(change->level)), group.on);
  else if (change)
    previewGroup(studio, index, change->level);
}

}  // namespace

void drawGroupRow(LightsContext& studio, size_t index) {
  const LightGroup group = studio.document().rig.groups[index];
  const MixerCard card(kHeight);
  const float side = px(kSwitchSide);
  const float gap = px(kFaderGap);
  const std::string mark = "mixer.group." + group.name;
  ImGui::PushID(group.name.c_str());
  card.toMiddleLine();
  groupName(studio, group, card);
  ImGui::SameLine(card.at(px(kNameWidth), 0).x);
  groupLevel(studio, index,
             card.innerWidth() - px(kNameWidth) - px(kNumberWidth) - side - px(kDotWidth) - 3 * gap);
  ImGui::SameLine(0, gap);
  if (toggleButton(kIconPower, group.on, kLitPower, side, "Turn the whole group on or off"))
    editGroup(studio, index, group.on ? "off" : "on", group.stops, !group.on);
  markItem({mark, ".on"});
  ImGui::SameLine(0, gap);
  if (changedDot("##reset", group.stops != 0 || !group.on, "Changed from the capture. Click to reset."))
    editGroup(studio, index, "reset", 0, true);
  markItem({mark, ".reset"});
  ImGui::PopID();
  card.end();
}

float ambientRowHeight() {
  return px(kHeight + kWideRow.gap);
}

void drawAmbientRow(LightsContext& studio) {
  const float ambient = studio.document().rig.ambient;
  const auto withAmbient = [&](float factor) {
    Document next = studio.document();
    next.rig.ambient = factor;
    return next;
  };
  const MixerCard card(kHeight);
  card.toMiddleLine();
  ImGui::TextUnformatted("Ambient");
  tooltip("Ambient light: what no controlled light explains.");
  ImGui::SameLine(card.at(px(kNameWidth), 0).x);
  float percent = 100 * ambient;
  ImGui::SetNextItemWidth(card.innerWidth() - px(kNameWidth) - px(kDotWidth) - px(kFaderGap));
  if (ImGui::SliderFloat("##ambient", &percent, 0, 200, "%.0f %%"))
    studio.editor.preview("Ambient", withAmbient(std::max(0.0F, percent / 100)));
  markItem("mixer.ambient");
  ImGui::SameLine(0, px(kFaderGap));
  if (changedDot("##reset ambient", ambient != 1, "Changed from the capture. Click to reset."))
    studio.editor.edit("Ambient: reset", withAmbient(1));
  markItem("mixer.ambient.reset");
  card.end();
}

}  // namespace swaplight
