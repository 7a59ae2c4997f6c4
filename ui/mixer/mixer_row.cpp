#include "ui/mixer/mixer_row.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "ui/control/light_edit.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/light_words.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/mixer/light_menu.h"
#include "ui/mixer/mixer_card.h"

namespace swaplight {
namespace {

constexpr float kRowHeight = 82;
constexpr float kChipSide = 32;

float timesOf(const LightSetting& setting) {
  return std::exp2(setting.stops) * setting.multiplier;
}

/// What a row says below the light's name.
std::string underName(const LightSetting& setting) {
  const float times = timesOf(setting);
  std::string words = colorWords(setting.color);
  words += times < 9.995F ? fmt::format("  ·  {:.0f} %", 100 * times) : fmt::format("  ·  ×{:.0f}", times);
  if (setting.role != Role::Other && roleName(setting.role) != setting.light)
    words = roleName(setting.role) + "  ·  " + words;
  if (!setting.group.empty()) words += "  ·  " + setting.group;
  return words;
}

/// Which lights are chosen after a click on this one, with the modifiers held.
void choose(LightsContext& studio, size_t light) {
  const ImGuiIO& io = ImGui::GetIO();
  const int index = static_cast<int>(light);
  std::set<int>& chosen = studio.view.selectedLights;
  if (io.KeyShift) {
    const int from = static_cast<int>(shownLight(studio));
    for (int i = std::min(from, index); i <= std::max(from, index); ++i) chosen.insert(i);
    return;
  }
  if (io.KeyCtrl) {
    if (chosen.empty()) chosen.insert(static_cast<int>(shownLight(studio)));
    if (chosen.count(index) > 0 && chosen.size() > 1)
      chosen.erase(index);
    else
      chosen.insert(index);
    studio.view.selectedLight = chosen.count(index) > 0 ? index : *chosen.begin();
    return;
  }
  chosen.clear();
  studio.view.selectedLight = index;
}

void nameField(LightsContext& studio, size_t light, float width) {
  MixerState& mixer = studio.mixer;
  ImGui::SetNextItemWidth(width);
  if (!mixer.nameFocused) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputText(
      "##name", &mixer.name, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  markItem({"mixer.", studio.document().rig.lights[light].light, ".name_field"});
  if (!entered && !(mixer.nameFocused && !ImGui::IsItemActive())) {
    mixer.nameFocused = mixer.nameFocused || ImGui::IsItemActive();
    return;
  }
  const bool cancelled = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (!cancelled) {
    Rig rig = studio.document().rig;
    rig.lights[light].label = mixer.name == rig.lights[light].light ? "" : mixer.name;
    editRig(studio, rig.lights[light].light + ": rename", rig);
  }
  mixer.renaming = -1;
}

void name(LightsContext& studio, size_t light, const LightSetting& setting, ImVec2 at, float width) {
  ImGui::SetCursorPos(ImVec2(at.x, at.y - px(2)));
  if (studio.mixer.renaming == static_cast<int>(light)) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(4), 0));
    nameField(studio, light, width);
    ImGui::PopStyleVar();
  } else {
    ImGui::PushFont(fonts().strong);
    ImGui::TextUnformatted(setting.title().c_str());
    ImGui::PopFont();
    if (setting.ratioLock) {
      ImGui::SameLine(0, px(4));
      ImGui::TextDisabled("%s", kIconLink);
    }
  }
  ImGui::SetCursorPos(ImVec2(at.x, at.y + px(18)));
  const ImVec2 clip = ImGui::GetCursorScreenPos();
  ImGui::PushClipRect(clip, ImVec2(clip.x + width, clip.y + px(30)), true);
  hint(underName(setting));
  ImGui::PopClipRect();
}

/// Mute, solo and on at the right end of a row.
void switches(LightsContext& studio, size_t light, const LightSetting& setting) {
  const float side = px(kSwitchSide);
  const float gap = px(4);
  const std::string mark = "mixer." + setting.light;
  if (toggleButton("M", setting.mute, kMute, side, "Mute  (M)")) {
    const bool mute = !setting.mute;
    editLights(studio, light, mute ? "mute" : "unmute", [&](LightSetting& changed) { changed.mute = mute; });
  }
  markItem({mark, ".mute"});
  ImGui::SameLine(0, gap);
  if (toggleButton("S", setting.solo, kSolo, side,
                   "Solo: all other lights off  (S). Alt-click: this light only."))
    toggleSolo(studio, light, ImGui::GetIO().KeyAlt);
  markItem({mark, ".solo"});
  ImGui::SameLine(0, gap);
  if (toggleButton(kIconPower, setting.on, kLitPower, side, "Turn on or off")) {
    const bool on = !setting.on;
    editLights(studio, light, on ? "on" : "off", [&](LightSetting& changed) { changed.on = on; });
  }
  markItem({mark, ".on"});
}

/// The intensity as a number in the unit that the person likes. True while it changes.
bool intensityNumber(LightsContext& studio, const LightSetting& setting, float* stops) {
  ImGui::SetNextItemWidth(px(kNumberWidth));
  if (studio.mixer.unit == MixerState::Unit::Stops)
    return ImGui::DragFloat("##number", stops, 0.02F, -kMostStops, kMostStops, "%+.2f st");
  const bool percent = studio.mixer.unit == MixerState::Unit::Percent;
  float value = timesOf(setting) * (percent ? 100 : 1);
  if (!ImGui::DragFloat("##number", &value, std::max(0.002F, value / 150), 1e-6F, 1e9F,
                        percent ? "%.1f %%" : "×%.3f"))
    return false;
  const float times = std::max(1e-8F, value / (percent ? 100 : 1));
  *stops = std::clamp(std::log2(times / std::max(1e-8F, setting.multiplier)), -kMostStops, kMostStops);
  return true;
}

void intensity(LightsContext& studio, size_t light, const LightSetting& setting, float width) {
  const std::string mark = "mixer." + setting.light;
  const float gap = px(6);
  float stops = setting.stops;
  bool changed =
      stopsSlider("##stops", &stops, kStopsRange, width - px(kDotWidth) - px(kNumberWidth) - 2 * gap);
  markItem({mark, ".stops"});
  tooltip("Level in stops relative to the capture. Double-click resets.");
  ImGui::SameLine(0, gap);
  changed |= intensityNumber(studio, setting, &stops);
  markItem({mark, ".number"});
  tooltip("Drag, or double-click to type. The mixer's menu sets the unit: stops, percent or multiplier.");
  if (changed) previewStops(studio, light, stops - setting.stops);
  ImGui::SameLine(0, gap);
  const bool differs = setting.stops != 0 || setting.multiplier != 1;
  if (changedDot("##reset stops", differs, "Changed from the capture. Click to reset."))
    editLights(studio, light, "reset intensity", [](LightSetting& reset) {
      reset.stops = 0;
      reset.multiplier = 1;
    });
  markItem({mark, ".reset"});
}

}  // namespace

void drawLightRow(LightsContext& studio, size_t light) {
  const LightSetting setting = studio.document().rig.lights[light];
  const std::string mark = "mixer." + setting.light;
  const int index = static_cast<int>(light);
  const std::set<int>& several = studio.view.selectedLights;
  const bool chosen = several.empty() ? shownLight(studio) == light : several.count(index) > 0;
  const MixerCard card(kRowHeight, chosen);
  const float nameAt = px(kChipSide + 10);
  const float switchesWidth = 3 * px(kSwitchSide) + 2 * px(4);
  const float nameWidth = card.innerWidth() - nameAt - switchesWidth - px(8);

  ImGui::PushID(index);
  // The row itself is clicked where nothing else of it is.
  const bool clicked = ImGui::InvisibleButton("##row", card.size());
  ImGui::SetItemAllowOverlap();
  markItem(mark);
  if (clicked) choose(studio, light);
  // Only the name's own place: a double-click on the number below it types a number.
  const ImVec2 corner = ImGui::GetItemRectMin();
  const ImVec2 nameCorner(corner.x + px(kCardPadding) + nameAt, corner.y);
  const bool onName = ImGui::IsMouseHoveringRect(
      nameCorner, ImVec2(nameCorner.x + nameWidth, corner.y + px(kCardPadding + 36)));
  if (ImGui::IsItemHovered() && onName && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
    beginRename(studio, light);
  if (ImGui::BeginPopupContextItem("##menu")) {
    if (ImGui::IsWindowAppearing() && several.count(index) == 0) choose(studio, light);
    drawLightMenu(studio, light);
    ImGui::EndPopup();
  }

  ImGui::SetCursorPos(card.at(0, 0));
  if (colorChip("##chip", chipColor(setting.color), ImVec2(px(kChipSide), px(kChipSide)),
                "Select this light"))
    choose(studio, light);
  markItem({mark, ".chip"});
  name(studio, light, setting, card.at(nameAt, 0), nameWidth);
  ImGui::SetCursorPos(card.at(card.innerWidth() - switchesWidth, px(3)));
  switches(studio, light, setting);
  ImGui::SetCursorPos(card.at(0, px(40)));
  intensity(studio, light, setting, card.innerWidth());
  ImGui::PopID();
  card.end();
}

}  // namespace swaplight
