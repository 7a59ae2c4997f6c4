#include "ui/mixer/mixer_row.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "core/relight/level.h"
#include "core/relight/live_level.h"
#include "ui/control/light_edit.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/light_words.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/mixer/level_field.h"
#include "ui/mixer/level_slider.h"
#include "ui/mixer/light_menu.h"
#include "ui/mixer/mixer_card.h"

namespace swaplight {
namespace {

constexpr float kHeldBackAlpha = 0.45F;  ///< of what belongs to a light that gives nothing now

/// What a row says below the light's name, after what comes out of it.
std::string underName(const LightSetting& setting) {
  std::string words = colorWords(setting.color);
  if (setting.role != Role::Other && roleName(setting.role) != setting.light)
    words = roleName(setting.role) + "  ·  " + words;
  if (!setting.group.empty()) words += "  ·  " + setting.group;
  return words;
}

/// The level that comes out of the light, or why nothing does.
std::string liveWords(const LiveLevel& live, bool unlit) {
  if (live.by != HeldBack::Nothing) return heldBackWords(live.by);
  if (unlit) return "no light yet";
  return live.level < 9.995 ? fmt::format("{:.0f} %", 100 * live.level) : fmt::format("×{:.0f}", live.level);
}

ImU32 liveInk(HeldBack by) {
  if (by == HeldBack::Nothing) return kText;
  if (by == HeldBack::Muted) return kMute;
  return by == HeldBack::NotInSolo ? kSolo : kChanged;
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

float smallWidth(const std::string& words) {
  ImGui::PushFont(fonts().small);
  const float width = ImGui::CalcTextSize(words.c_str()).x;
  ImGui::PopFont();
  return width;
}

/// The live level and the light's colour, below its name.
void secondLine(const LightSetting& setting, const LiveLevel& live, bool unlit, ImVec2 at, float width) {
  ImGui::SetCursorPos(at);
  const ImVec2 clip = ImGui::GetCursorScreenPos();
  ImGui::PushClipRect(clip, ImVec2(clip.x + width, clip.y + px(30)), true);
  const std::string words = liveWords(live, unlit);
  ImGui::PushFont(fonts().small);
  ImGui::PushStyleColor(ImGuiCol_Text, unlit ? kChanged : liveInk(live.by));
  ImGui::TextUnformatted(words.c_str());
  ImGui::PopStyleColor();
  markItem({"mixer.", setting.light, ".live"});
  markState("mixer." + setting.light + ".live", words);
  ImGui::SameLine(0, px(8));
  const std::string under = underName(setting),
                    cut = cutToWidth(under, at.x + width - ImGui::GetCursorPosX());
  ImGui::TextUnformatted(cut.c_str());
  ImGui::PopFont();
  if (cut != under) tooltip(under.c_str());
  ImGui::PopClipRect();
}

/// A chip of a light that gives nothing is hollow.
void hollowChip(ImVec2 low, float side) {
  const float rim = px(5);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(low.x + rim, low.y + rim),
                                            ImVec2(low.x + side - rim, low.y + side - rim), kCard, px(2));
}

void name(LightsContext& studio, size_t light, const LightSetting& setting, ImVec2 at, float width) {
  ImGui::SetCursorPos(ImVec2(at.x, at.y - px(2)));
  const ImVec2 clip = ImGui::GetCursorScreenPos();
  ImGui::PushClipRect(clip, ImVec2(clip.x + width, clip.y + px(30)), true);
  if (studio.mixer.renaming == static_cast<int>(light)) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(4), 0));
    nameField(studio, light, width);
    ImGui::PopStyleVar();
  } else {
    ImGui::TextDisabled("%zu", light + 1);
    markItem({"mixer.", setting.light, ".number_of_light"});
    ImGui::SameLine(0, px(6));
    ImGui::PushFont(fonts().strong);
    const float lock = setting.ratioLock ? ImGui::CalcTextSize(kIconLink).x + px(4) : 0;
    const std::string title = setting.title();
    const std::string cut = cutToWidth(title, at.x + width - lock - ImGui::GetCursorPosX());
    ImGui::TextUnformatted(cut.c_str());
    ImGui::PopFont();
    markState("mixer." + setting.light + ".title", cut);
    if (cut != title) tooltip(title.c_str());
    if (setting.ratioLock) {
      ImGui::SameLine(0, px(4));
      ImGui::TextDisabled("%s", kIconLink);
    }
  }
  ImGui::PopClipRect();
}

/// Mute, solo and on at the right end of a row.
void switches(LightsContext& studio, size_t light, const LightSetting& setting) {
  const float side = px(kSwitchSide);
  const float gap = px(4);
  const std::string mark = "mixer." + setting.light;
  if (toggleButton(
          "M", setting.mute, kMute, side,
          "Mute: out for a moment, and back as it was (M). Not copied with the light, not in rig texts.")) {
    const bool mute = !setting.mute;
    editLights(studio, light, mute ? "mute" : "unmute", [&](LightSetting& changed) { changed.mute = mute; });
  }
  markItem({mark, ".mute"});
  ImGui::SameLine(0, gap);
  if (toggleButton("S", setting.solo, kSolo, side,
                   "Solo: lights without it are out while it is lit (S). Alt-click: this light only."))
    toggleSolo(studio, light, ImGui::GetIO().KeyAlt);
  markItem({mark, ".solo"});
  ImGui::SameLine(0, gap);
  if (toggleButton(
          kIconPower, setting.on, kLitPower, side,
          "On or off: part of the light's setting, which looks keep and copies take along. To compare, "
          "mute.")) {
    const bool on = !setting.on;
    editLights(studio, light, on ? "on" : "off", [&](LightSetting& changed) { changed.on = on; });
  }
  markItem({mark, ".on"});
}

void intensity(LightsContext& studio, size_t light, const LightSetting& setting, float width) {
  const std::string mark = "mixer." + setting.light;
  const float gap = px(6);
  const double level = levelOf(setting);
  float stops = level > 0 ? static_cast<float>(std::log2(level)) : -kStopsRange;
  const LevelSliding sliding =
      levelSlider("##stops", &stops, kStopsRange, width - px(kDotWidth) - px(kNumberWidth) - 2 * gap);
  markItem({mark, ".stops"});
  tooltip(
      "Level in stops relative to the capture. Shift drags finely, wheel and arrow keys step, double-click "
      "resets.");
  keepNudges(studio.mixer, mark, sliding);
  if (sliding.toType) typeLevel(studio.mixer, mark, level);
  if (sliding.changed) previewLevel(studio, light, std::exp2(static_cast<double>(stops)));
  ImGui::SameLine(0, gap);
  const bool differs = setting.stops != 0 || setting.multiplier != 1;
  if (changedDot("##reset stops", differs, "Changed from the capture. Click to reset."))
    editLights(studio, light, "reset intensity", [](LightSetting& reset) {
      reset.stops = 0;
      reset.multiplier = 1;
    });
  markItem({mark, ".reset"});
  // The number comes last: it ends where the switches above it end.
  ImGui::SameLine(0, gap);
  if (const auto change = levelField(studio, mark, level)) {
    if (change->typed)
      editLevel(studio, light, change->level);
    else
      previewLevel(studio, light, change->level);
  }
}

}  // namespace

const RowShape& rowShape(size_t lights, float room) {
  const float wanted = static_cast<float>(lights) * (kWideRow.height + kWideRow.gap) - kWideRow.gap;
  return px(wanted) > room ? kNarrowRow : kWideRow;
}

void drawLightRow(LightsContext& studio, size_t light, const RowShape& shape) {
  const LightSetting setting = studio.document().rig.lights[light];
  const std::string mark = "mixer." + setting.light;
  const int index = static_cast<int>(light);
  const std::set<int>& several = studio.view.selectedLights;
  const bool chosen = several.empty() ? shownLight(studio) == light : several.count(index) > 0;
  const LiveLevel live = liveLevel(studio.document().rig, light);
  const bool unlit = studio.edits.isUnlit(setting.light);
  const bool shines = live.by == HeldBack::Nothing && !unlit;
  const MixerCard card(shape, chosen);
  const float nameAt = px(shape.chip + 10);
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
      nameCorner, ImVec2(nameCorner.x + nameWidth, corner.y + px(shape.padding + shape.level) - px(4)));
  if (ImGui::IsItemHovered() && onName && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
    beginRename(studio, light);
  if (ImGui::BeginPopupContextItem("##menu")) {
    if (ImGui::IsWindowAppearing() && several.count(index) == 0) choose(studio, light);
    drawLightMenu(studio, light);
    ImGui::EndPopup();
  }

  ImGui::SetCursorPos(card.at(0, 0));
  const ImVec2 chip = ImGui::GetCursorScreenPos();
  if (colorChip("##chip", chipColor(setting.color), ImVec2(px(shape.chip), px(shape.chip)),
                "Select this light. A hollow chip: nothing comes out of it now."))
    choose(studio, light);
  markItem({mark, ".chip"});
  if (!shines) hollowChip(chip, px(shape.chip));
  const float alpha = shines ? ImGui::GetStyle().Alpha : kHeldBackAlpha;
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, alpha);
  // In a narrow row the name is in the middle of its line, and what is else under it stands beside it.
  const float nameDown = shape.narrow ? px(shape.under) : 0;
  // What comes out of the light is read at a glance: a long name gives way.
  const float nameRoom = shape.narrow ? nameWidth - smallWidth(liveWords(live, unlit)) - px(8) : nameWidth;
  name(studio, light, setting, card.at(nameAt, nameDown), nameRoom);
  const float nameEnd =
      shape.narrow ? ImGui::GetItemRectMax().x - corner.x + px(8) : px(kCardPadding) + nameAt;
  ImGui::PopStyleVar();
  const float wordsRoom = px(kCardPadding) + nameAt + nameWidth - nameEnd;
  if (wordsRoom > 0)
    secondLine(setting, live, unlit,
               ImVec2(card.at(0, 0).x - px(kCardPadding) + nameEnd, card.at(0, px(shape.under)).y),
               wordsRoom);
  ImGui::SetCursorPos(card.at(card.innerWidth() - switchesWidth, shape.narrow ? 0 : px(3)));
  switches(studio, light, setting);
  ImGui::SetCursorPos(card.at(0, px(shape.level)));
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, alpha);
  ImVec2 padding = ImGui::GetStyle().FramePadding;
  if (shape.narrow) padding.y = px(1);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
  intensity(studio, light, setting, card.innerWidth());
  ImGui::PopStyleVar(2);
  ImGui::PopID();
  card.end();
}

}  // namespace swaplight
