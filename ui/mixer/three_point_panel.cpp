#include "ui/mixer/three_point_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/look/three_point.h"
#include "ui/control/light_edit.h"
#include "ui/control/look_edit.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/light_words.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kLabelWidth = 92;
constexpr float kWordsWidth = 116;
constexpr float kGap = 4;
constexpr int kColumns = 3;
constexpr float kFlattest = -1, kSteepest = 6;  ///< stops of key over fill
constexpr float kMostBack = 4;                  ///< stops of back over key

/// The light that has the role; another choice takes the role from it.
void roleCombo(LightsContext& studio, Role role, float width) {
  const Rig& rig = studio.document().rig;
  const std::vector<size_t> lights = lightsOfRole(rig, role);
  std::string words = roleName(role) + ": ";
  if (lights.empty()) words += "none";
  if (!lights.empty()) words += rig.lights[lights.front()].title();
  if (lights.size() > 1) words += fmt::format(" +{}", lights.size() - 1);
  ImGui::SetNextItemWidth(width);
  const std::string mark = "three_point.role." + roleName(role);
  const bool open = ImGui::BeginCombo(("##" + roleName(role)).c_str(), words.c_str());
  if (open) {
    for (size_t i = 0; i < rig.lights.size(); ++i) {
      if (!ImGui::Selectable(rig.lights[i].title().c_str(), rig.lights[i].role == role)) {
        markItem({mark, ".", rig.lights[i].light});
        continue;
      }
      Rig next = rig;
      for (const size_t other : lights) next.lights[other].role = Role::Other;
      next.lights[i].role = role;
      editRig(studio, rig.lights[i].title() + ": role " + roleName(role), next);
      break;
    }
    ImGui::EndCombo();
  }
  markItem(mark);
  tooltip(("Which light is the " + roleName(role) + "; to give several lights a role, use their own menus.")
              .c_str());
}

/// A slider between what it is and, in words, how it stands.
bool labelledSlider(const char* label, float* value, float low, float high) {
  ImGui::AlignTextToFramePadding();
  hint(label);
  ImGui::SameLine(px(kLabelWidth));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - px(kWordsWidth) - px(kGap));
  ImGui::PushID(label);
  const bool changed = ImGui::SliderFloat("##value", value, low, high, "");
  ImGui::PopID();
  return changed;
}

/// How a ratio stands, or why there is none.
std::string levelWords(const Rig& rig, Role role, Role other, const std::string& level) {
  for (const Role needed : {role, other}) {
    const std::vector<size_t> lights = lightsOfRole(rig, needed);
    if (lights.empty()) return "no light is " + roleName(needed);
    const LightSetting& light = rig.lights[lights.front()];
    if (!light.on || light.mute) return roleName(needed) + " is off";
  }
  return level;
}

/// "0.8 st under key", as people say it.
std::string overKeyWords(float stops) {
  if (std::abs(stops) < 0.05F) return "as bright as key";
  return fmt::format("{:.1f} st {} key", std::abs(stops), stops > 0 ? "over" : "under");
}

/// To be called after the slider's mark and tooltip.
void wordsBeside(const std::string& words) {
  ImGui::SameLine(0, px(kGap));
  ImGui::AlignTextToFramePadding();
  hint(words);
}

void previewRig(LightsContext& studio, const std::string& step, Rig rig) {
  Document next = studio.document();
  next.rig = std::move(rig);
  studio.editor.preview(step, std::move(next));
}

void keyToFill(LightsContext& studio) {
  const Rig& rig = studio.document().rig;
  const LightRatios& ratios = lightRatios(studio);
  const std::optional<float> measured = stopsOverRole(rig, ratios, Role::Key, Role::Fill);
  ImGui::BeginDisabled(!measured);
  float stops = measured.value_or(0);
  if (labelledSlider("Key : fill", &stops, kFlattest, kSteepest))
    previewRig(studio, "Key : fill", withStopsOverRole(rig, ratios, Role::Fill, Role::Key, -stops));
  markItem("three_point.ratio");
  tooltip(
      "Lighting ratio where both lights reach, as a meter on set reads it. Dims the fill to match. "
      "Ctrl-click to type stops.");
  wordsBeside(
      levelWords(rig, Role::Fill, Role::Key, fmt::format("{}   {:+.1f} st", ratioWords(stops), stops)));
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(px(kLabelWidth));
  const float width = std::floor((ImGui::GetContentRegionAvail().x - 4 * px(kGap)) / 5);
  for (int power = 0; power <= 4; ++power) {
    const std::string ratio = ratioWords(static_cast<float>(power));
    if (power > 0) ImGui::SameLine(0, px(kGap));
    if (ImGui::Button(ratio.c_str(), ImVec2(width, 0)))
      editRig(studio, "Key : fill " + ratio,
              withStopsOverRole(rig, ratios, Role::Fill, Role::Key, -static_cast<float>(power)));
    markItem({"three_point.ratio.", 1 << power});
  }
  ImGui::EndDisabled();
}

void backLevel(LightsContext& studio) {
  const Rig& rig = studio.document().rig;
  const LightRatios& ratios = lightRatios(studio);
  const std::optional<float> measured = stopsOverRole(rig, ratios, Role::Back, Role::Key);
  ImGui::BeginDisabled(!measured);
  float stops = measured.value_or(0);
  if (labelledSlider("Back", &stops, -kMostBack, kMostBack))
    previewRig(studio, "Back level", withStopsOverRole(rig, ratios, Role::Back, Role::Key, stops));
  markItem("three_point.back");
  tooltip("How much brighter the back light is than the key, where both reach. Ctrl-click to type stops.");
  wordsBeside(levelWords(rig, Role::Back, Role::Key, overKeyWords(stops)));
  ImGui::EndDisabled();
}

void warmCool(LightsContext& studio) {
  const Rig& rig = studio.document().rig;
  const std::vector<size_t> keys = lightsOfRole(rig, Role::Key), fills = lightsOfRole(rig, Role::Fill);
  ImGui::BeginDisabled(keys.empty() || fills.empty());
  const std::optional<float> measured = warmCoolSplit(rig);
  float mired = measured.value_or(0);
  const auto words = [&]() -> std::string {
    if (keys.empty() || fills.empty()) return "no key and fill";
    if (!measured) return "coloured";
    if (*measured == 0) return "none";
    return fmt::format("{} / {}", colorWords(rig.lights[keys.front()].color),
                       colorWords(rig.lights[fills.front()].color));
  };
  const std::string split = words();
  if (labelledSlider("Warm / cool", &mired, -kMostSplit, kMostSplit))
    previewRig(studio, "Warm / cool", withWarmCoolSplit(rig, std::abs(mired) < 8 ? 0 : mired));
  markItem("three_point.split");
  tooltip("Right: warm key, cool fill. Left: cool key, warm fill.");
  wordsBeside(split);
  ImGui::EndDisabled();
}

void presets(LightsContext& studio) {
  const LookState::Blend* blend = activeBlend(studio);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - (kColumns - 1) * px(kGap)) / kColumns);
  ImGui::PushFont(fonts().small);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(2), px(3)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(kGap), px(kGap)));
  int column = 0;
  for (const Look& look : presetLooks()) {
    if (column++ % kColumns > 0) ImGui::SameLine();
    const bool lit = blend && blend->name == look.name;
    for (const ImGuiCol color : {ImGuiCol_Button, ImGuiCol_ButtonHovered})
      if (lit) ImGui::PushStyleColor(color, kAccent);
    const bool clicked = ImGui::Button(look.name.c_str(), ImVec2(width, 0));
    if (lit) ImGui::PopStyleColor(2);
    std::string mark = "three_point.look." + look.name;
    std::replace(mark.begin(), mark.end(), ' ', '_');
    markItem(mark);
    tooltip(look.words.c_str());
    if (clicked) applyPreset(studio, look);
  }
  // The amount fills the rest of the last line.
  ImGui::SameLine();
  blend = activeBlend(studio);
  ImGui::BeginDisabled(!blend);
  float percent = blend ? 100 * blend->amount : 100;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (ImGui::SliderFloat("##amount", &percent, 0, 100, blend ? "%.0f %%" : "strength of a look",
                         ImGuiSliderFlags_AlwaysClamp))
    previewBlend(studio, percent / 100);
  markItem("three_point.amount");
  ImGui::EndDisabled();
  ImGui::PopStyleVar(2);
  ImGui::PopFont();
}

}  // namespace

void drawThreePointPanel(LightsContext& studio) {
  if (!studio.set()) return;
  ImGui::PushFont(fonts().strong);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Three-point");
  ImGui::PopFont();
  const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * px(kGap)) / 3);
  bool first = true;
  for (const Role role : {Role::Key, Role::Fill, Role::Back}) {
    if (!std::exchange(first, false)) ImGui::SameLine(0, px(kGap));
    roleCombo(studio, role, width);
  }
  keyToFill(studio);
  backLevel(studio);
  warmCool(studio);
  presets(studio);
}

}  // namespace swaplight
