#include "ui/mixer/level_field.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/relight/level.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/mixer/mixer_card.h"

namespace swaplight {
namespace {

constexpr const char* kTip =
    "Drag, with Shift finer. Double-click to type: 50%, @50, full, x2, -1st; Tab goes on to the next light. "
    "The mixer's menu sets the unit.";

std::string textOfLevel(LevelUnit unit, double level) {
  if (level == 0) return "out";
  switch (unit) {
    case LevelUnit::Stops:
      return fmt::format("{:+.2f} st", std::log2(level));
    case LevelUnit::Percent:
      return fmt::format("{:.1f} %", 100 * level);
    case LevelUnit::Multiplier:
      break;
  }
  return fmt::format("\u00d7{:.3f}", level);
}

bool beyondSlider(double level) {
  return level != 0 && std::abs(std::log2(level)) > static_cast<double>(kStopsRange);
}

/// How far from the captured level a drag leads: to the slider's ends, or to where the level is now.
double mostStops(double level) {
  return level > 0 ? std::max(static_cast<double>(kStopsRange), std::abs(std::log2(level)))
                   : static_cast<double>(kStopsRange);
}

std::optional<LevelChange> draggedLevel(LightsContext& studio, const std::string& mark, double level) {
  const LevelUnit unit = studio.mixer.unit;
  const bool stops = unit == LevelUnit::Stops;
  const double times = unit == LevelUnit::Percent ? 100 : 1, most = mostStops(level);
  const auto shown = [&](double of) { return static_cast<float>(stops ? std::log2(of) : times * of); };
  const float lowest = shown(std::exp2(-most)), highest = shown(std::exp2(most));
  float value = level > 0 ? shown(level) : lowest;
  float speed = stops ? 0.02F : std::max(0.002F, value / 150);
  if (ImGui::GetIO().KeyShift) speed /= 100;  // Dear ImGui makes it ten times faster
  // As a format, the words are themselves.
  std::string words = textOfLevel(unit, level);
  for (size_t at = 0; (at = words.find('%', at)) != std::string::npos; at += 2) words.insert(at, "%");
  const bool changed = ImGui::DragFloat("##number", &value, speed, lowest, highest, words.c_str(),
                                        ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat);
  markItem({mark, ".number"});
  tooltip(kTip);
  const bool clicked = ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  if (clicked && (ImGui::GetIO().KeyCtrl || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)))
    typeLevel(studio.mixer, mark, level);
  if (!changed) return std::nullopt;
  const double now = static_cast<double>(value);
  return LevelChange{stops ? std::exp2(now) : now / times, false};
}

/// Says below the field why it is still being typed into.
void noteBelow(const std::string& note) {
  if (note.empty()) return;
  const ImVec2 high = ImGui::GetItemRectMax();
  ImGui::SetNextWindowPos(ImVec2(high.x, high.y + px(4)), ImGuiCond_Always, ImVec2(1, 0));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(px(320));
  ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kChanged), "%s", note.c_str());
  ImGui::PopTextWrapPos();
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  markRect("mixer.level_note", at.x, at.y, at.x + size.x, at.y + size.y);
  ImGui::EndTooltip();
}

/// What was typed, when it is over. A wrong or doubtful one is typed on.
std::optional<LevelChange> accepted(MixerState& mixer, bool entered) {
  LevelTyping& typing = mixer.typing;
  const auto again = [&](const std::string& note) {
    typing.note = note;
    typing.focused = false;
    return std::nullopt;
  };
  try {
    const double level = wantedLevel(typing.text, mixer.unit);
    if (beyondSlider(level) && !entered) {
      typing = {};
      return std::nullopt;
    }
    if (beyondSlider(level) && typing.doubted != typing.text) {
      typing.doubted = typing.text;
      return again(
          fmt::format("{} is beyond the slider, which ends at {:.0f} stops. Enter takes it all the same.",
                      textOfLevel(mixer.unit, level), kStopsRange));
    }
    typing = {};
    return LevelChange{level, true};
  } catch (const InputError& error) {
    if (entered) return again(error.what());
    typing = {};
    return std::nullopt;
  }
}

std::optional<LevelChange> typedLevel(LightsContext& studio, const std::string& mark, double level) {
  MixerState& mixer = studio.mixer;
  LevelTyping& typing = mixer.typing;
  if (!typing.focused) ImGui::SetKeyboardFocusHere();
  bool tabbed = false;
  const auto onTab = [](ImGuiInputTextCallbackData* data) {
    *static_cast<bool*>(data->UserData) = true;
    return 0;
  };
  const bool entered =
      ImGui::InputText("##typed", &typing.text,
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
                           ImGuiInputTextFlags_CallbackCompletion,
                       onTab, &tabbed);
  markItem({mark, ".number"});
  markTip();
  noteBelow(typing.note);
  const bool left = typing.focused && !ImGui::IsItemActive();
  typing.focused = typing.focused || ImGui::IsItemActive();
  if (!entered && !left && !tabbed) return std::nullopt;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
    typing = {};
    return std::nullopt;
  }
  const bool asItWas = typing.text == textOfLevel(mixer.unit, level);  // the words round it
  if (asItWas) typing = {};
  const std::optional<LevelChange> change = asItWas ? std::nullopt : accepted(mixer, entered || tabbed);
  if (tabbed && (change || asItWas)) mixer.typeNextLevel = true;
  return change;
}

}  // namespace

void typeLevel(MixerState& mixer, const std::string& mark, double level) {
  mixer.typing = {};
  mixer.typing.row = mark;
  mixer.typing.text = textOfLevel(mixer.unit, level);
}

std::optional<LevelChange> levelField(LightsContext& studio, const std::string& mark, double level) {
  if (std::exchange(studio.mixer.typeNextLevel, false)) typeLevel(studio.mixer, mark, level);
  ImGui::SetNextItemWidth(px(kNumberWidth));
  return studio.mixer.typing.row == mark ? typedLevel(studio, mark, level)
                                         : draggedLevel(studio, mark, level);
}

}  // namespace swaplight
