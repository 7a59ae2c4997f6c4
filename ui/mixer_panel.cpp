#include "ui/mixer_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/relight/setting.h"
#include "ui/icons.h"
#include "ui/layout_probe.h"
#include "ui/light_edit.h"
#include "ui/light_panel.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace swaplight {
namespace {

constexpr float kStopsRange = 8;  ///< of the slider
constexpr float kMostStops = 30;  ///< that can be typed
constexpr float kRowHeight = 82;
constexpr float kAmbientHeight = 48;
constexpr float kPadding = 9;

/// What a row says below the light's name: its colour and how much light it gives.
std::string underName(const LightSetting& setting) {
  const float times = std::exp2(setting.stops) * setting.multiplier;
  const std::string amount =
      times < 9.995F ? fmt::format("{:.0f} %", 100 * times) : fmt::format("×{:.0f}", times);
  return fmt::format("{}  ·  {}", colorWords(setting.color), amount);
}

void drawCard(ImVec2 at, ImVec2 size, bool chosen) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 high(at.x + size.x, at.y + size.y);
  draw->AddRectFilled(at, high, chosen ? kCardChosen : kCard, px(6));
  if (chosen) draw->AddRect(at, high, kAccent, px(6), 0, px(1));
}

/// On, solo and mute at the right end of a row.
void switches(StudioContext& studio, size_t index, LightSetting setting, float right) {
  const float side = px(26);
  const float gap = px(4);
  ImGui::SetCursorPosX(right - 3 * side - 2 * gap);
  const std::string mark = "mixer." + setting.light;
  if (toggleButton("M", setting.mute, kMute, side, "Mute")) {
    setting.mute = !setting.mute;
    editLight(studio, index, setting.mute ? "mute" : "unmute", setting);
  }
  markItem(mark + ".mute");
  ImGui::SameLine(0, gap);
  if (toggleButton("S", setting.solo, kSolo, side, "Solo: the others are dark")) {
    setting.solo = !setting.solo;
    editLight(studio, index, setting.solo ? "solo" : "solo off", setting);
  }
  markItem(mark + ".solo");
  ImGui::SameLine(0, gap);
  if (toggleButton(kIconPower, setting.on, IM_COL32(92, 110, 92, 255), side, "On or off")) {
    setting.on = !setting.on;
    editLight(studio, index, setting.on ? "on" : "off", setting);
  }
  markItem(mark + ".on");
}

void stops(StudioContext& studio, size_t index, LightSetting setting, float width) {
  const std::string mark = "mixer." + setting.light;
  const float dot = px(14);
  const float number = px(82);
  const float gap = px(6);
  bool changed = stopsSlider("##stops", &setting.stops, kStopsRange, width - dot - number - 2 * gap);
  markItem(mark + ".stops");
  tooltip("Intensity in stops over the capture. Double-click resets.");
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(number);
  changed |= ImGui::DragFloat("##number", &setting.stops, 0.02F, -kMostStops, kMostStops, "%+.2f st");
  markItem(mark + ".number");
  tooltip("Drag, or double-click and type.");
  if (changed) previewLight(studio, index, "stops", setting);
  ImGui::SameLine(0, gap);
  const bool differs = setting.stops != 0 || setting.multiplier != 1;
  if (changedDot("##reset stops", differs, "Differs from the capture. Click to reset.")) {
    setting.stops = 0;
    setting.multiplier = 1;
    editLight(studio, index, "reset stops", setting);
  }
  markItem(mark + ".reset");
}

void lightRow(StudioContext& studio, size_t index) {
  const LightSetting setting = studio.document().rig.lights[index];
  const std::string mark = "mixer." + setting.light;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, px(kRowHeight));
  const bool chosen = studio.view.selectedLight == static_cast<int>(index);
  drawCard(at, size, chosen);
  markRect(mark, at.x, at.y, at.x + size.x, at.y + size.y);

  ImGui::PushID(static_cast<int>(index));
  const ImVec2 start = ImGui::GetCursorPos();
  // The row itself is clicked where nothing else of it is.
  ImGui::SetItemAllowOverlap();
  if (ImGui::InvisibleButton("##row", size)) studio.view.selectedLight = static_cast<int>(index);
  ImGui::SetItemAllowOverlap();

  const float pad = px(kPadding);
  const float inner = size.x - 2 * pad;
  ImGui::SetCursorPos(ImVec2(start.x + pad, start.y + pad));
  if (colorChip("##chip", chipColor(setting.color), ImVec2(px(32), px(32)), "Choose this light"))
    studio.view.selectedLight = static_cast<int>(index);
  markItem(mark + ".chip");
  ImGui::SetCursorPos(ImVec2(start.x + pad + px(42), start.y + pad - px(2)));
  ImGui::BeginGroup();
  ImGui::PushFont(fonts().strong);
  ImGui::TextUnformatted(setting.light.c_str());
  ImGui::PopFont();
  ImGui::SetCursorPosY(start.y + pad + px(17));
  hint(underName(setting));
  ImGui::EndGroup();

  ImGui::SetCursorPos(ImVec2(start.x, start.y + pad + px(3)));
  switches(studio, index, setting, start.x + pad + inner);
  ImGui::SetCursorPos(ImVec2(start.x + pad, start.y + pad + px(40)));
  stops(studio, index, setting, inner);
  ImGui::SetCursorPos(ImVec2(start.x, start.y + size.y + px(6)));
  ImGui::PopID();
}

/// What no light explains.
void ambientRow(StudioContext& studio) {
  const Document& document = studio.document();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, px(kAmbientHeight));
  drawCard(at, size, false);
  const ImVec2 start = ImGui::GetCursorPos();
  const float pad = px(kPadding);
  ImGui::SetCursorPos(ImVec2(start.x + pad, start.y + (size.y - ImGui::GetFrameHeight()) / 2));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Ambient");
  tooltip("The light that no lamp of the capture explains.");
  ImGui::SameLine(px(92));
  float percent = 100 * document.rig.ambient;
  const float dot = px(14);
  ImGui::SetNextItemWidth(size.x - ImGui::GetCursorPosX() + start.x - pad - dot - px(6));
  if (ImGui::SliderFloat("##ambient", &percent, 0, 200, "%.0f %%")) {
    Document next = document;
    next.rig.ambient = std::max(0.0F, percent / 100);
    studio.editor.preview("ambient", std::move(next));
  }
  markItem("mixer.ambient");
  ImGui::SameLine(0, px(6));
  if (changedDot("##reset ambient", document.rig.ambient != 1, "Differs from the capture. Click to reset.")) {
    Document next = document;
    next.rig.ambient = 1;
    studio.editor.edit("reset ambient", std::move(next));
  }
  ImGui::SetCursorPos(ImVec2(start.x, start.y + size.y + px(6)));
}

}  // namespace

void drawMixerPanel(StudioContext& studio) {
  const Rig& rig = studio.document().rig;
  if (rig.lights.empty()) return;
  const float inspector = lightPanelHeight() + ImGui::GetStyle().ItemSpacing.y;
  const float rows = std::max(px(kRowHeight + 12), ImGui::GetContentRegionAvail().y - inspector);
  ImGui::BeginChild("##rows", ImVec2(0, rows));
  for (size_t i = 0; i < rig.lights.size(); ++i) lightRow(studio, i);
  const OpenSet* set = studio.set();
  if (set && set->solved->ambient) ambientRow(studio);
  ImGui::EndChild();
  ImGui::Separator();
  drawLightPanel(studio);
}

}  // namespace swaplight
