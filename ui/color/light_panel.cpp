#include "ui/color/light_panel.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/color/chromaticity.h"
#include "core/color/hsv.h"
#include "core/color/srgb.h"
#include "core/lamp/kelvin.h"
#include "core/relight/setting.h"
#include "ui/color/color_disc.h"
#include "ui/color/swatch_row.h"
#include "ui/control/light_edit.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/gel_list.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/light_words.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kDiscSide = 150;
constexpr std::array<float, 6> kWhites = {1900, 2700, 3200, 4300, 5600, 6500};

/// One light's colour being looked at and changed.
struct ColorEditor {
  LightsContext& studio;
  size_t light;
  const LightColor& color;

  [[nodiscard]] Rgb codes() const {
    return color.kind == LightColor::Kind::Hex ? color.value : chipColor(color);
  }
  void preview(const std::string& what, const LightColor& next) const {
    previewLights(studio, light, what, [&](LightSetting& setting) { setting.color = next; });
  }
  void previewCodes(const Rgb& codes) const { preview("colour", hexColor(codes)); }
};

/// The hue of a grey is the last one that there was.
Rgb hsvOf(const ColorEditor& edit) {
  Rgb hsv = hsvFromRgb(edit.codes());
  float& hue = edit.studio.mixer.hue;
  if (hsv.y > 0)
    hue = hsv.x;
  else
    hsv.x = hue;
  return hsv;
}

void disc(const ColorEditor& edit) {
  Rgb hsv = hsvOf(edit);
  if (colorDisc("##disc", hsv, px(kDiscSide))) {
    edit.studio.mixer.hue = hsv.x;
    edit.previewCodes(rgbFromHsv(hsv));
  }
  markItem("light.disc");
  tooltip(
      "Press or drag: white in the middle, full colour at the rim. Shift drags finely. How bright the light "
      "is, its slider above says.");
}

/// Three numbers side by side. True when one changes.
bool threeNumbers(const char* id, std::array<float, 3>& values, const std::array<float, 3>& highest,
                  const std::array<const char*, 3>& formats) {
  bool changed = false;
  const float gap = px(4);
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  ImGui::PushID(id);
  for (size_t i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(std::floor(width));
    ImGui::PushID(static_cast<int>(i));
    changed |= ImGui::DragFloat("##value", &values[i], highest[i] / 400, 0, highest[i], formats[i],
                                ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopID();
  }
  ImGui::PopID();
  return changed;
}

void numbers(const ColorEditor& edit) {
  const Rgb codes = edit.codes();
  std::array<float, 3> rgb{std::round(255 * codes.r), std::round(255 * codes.g), std::round(255 * codes.b)};
  if (threeNumbers("rgb", rgb, {255, 255, 255}, {"R %.0f", "G %.0f", "B %.0f"}))
    edit.previewCodes(Rgb(rgb[0], rgb[1], rgb[2]) / 255.0F);
  markItem("light.rgb");
  const Rgb hsv = hsvOf(edit);
  std::array<float, 3> shown{360 * hsv.x, 100 * hsv.y, 100 * hsv.z};
  if (threeNumbers("hsv", shown, {360, 100, 100}, {"H %.0f", "S %.0f", "V %.0f"})) {
    edit.studio.mixer.hue = shown[0] / 360;
    edit.previewCodes(rgbFromHsv(Rgb(shown[0] / 360, shown[1] / 100, shown[2] / 100)));
  }
  markItem("light.hsv");
}

/// The colour as text; also takes any setting.
void settingField(const ColorEditor& edit) {
  std::string text = hexText(edit.codes());
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (ImGui::InputText("##hex", &text,
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll)) {
    try {
      LightSetting probe;
      applySetting(probe, text);
      editLights(edit.studio, edit.light, text, [&](LightSetting& setting) { applySetting(setting, text); });
    } catch (const InputError& error) {
      edit.studio.messages.error(error.what());
    }
  }
  markItem("light.hex");
  tooltip("Type an sRGB hex code or any setting: 3200K, rgb:1/0.5/0.2, gel:L201, +1st.");
}

void pickers(const ColorEditor& edit) {
  const ActionTable& actions = edit.studio.actions;
  const float width = std::floor((ImGui::GetContentRegionAvail().x - px(4)) / 2);
  actionTextButton(actions, "light.neutral", "Neutral", width);
  ImGui::SameLine(0, px(4));
  actionTextButton(actions, "light.match", "Match", width);
}

void temperature(const ColorEditor& edit) {
  const float number = px(88);
  const float gap = px(4);
  const float arrow = ImGui::GetFrameHeight();
  const auto show = [&](float kelvin) {
    LightColor next = edit.color;
    next.kind = LightColor::Kind::Kelvin;
    next.kelvin = std::clamp(kelvin, 1000.0F, 25000.0F);
    edit.preview("temperature", next);
  };
  float kelvin = edit.color.kelvin;
  if (kelvinSlider("##kelvin", &kelvin, ImGui::GetContentRegionAvail().x - number - arrow - 2 * gap))
    show(kelvin);
  markItem("light.kelvin");
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(number);
  const bool isKelvin = edit.color.kind == LightColor::Kind::Kelvin;
  if (!isKelvin) ImGui::PushStyleColor(ImGuiCol_Text, kFaint);
  if (ImGui::DragFloat("##kelvin number", &kelvin, 20, 1000, 25000, "%.0f K")) show(kelvin);
  if (!isKelvin) ImGui::PopStyleColor();
  markItem("light.kelvin.number");
  tooltip("Drag, or double-click to type.");
  ImGui::SameLine(0, gap);
  const bool open = ImGui::BeginCombo("##whites", "", ImGuiComboFlags_NoPreview);
  if (open) {
    for (const float white : kWhites) {
      const std::string words = fmt::format("{:.0f} K", white);
      if (ImGui::Selectable(words.c_str(), isKelvin && kelvin == white))
        editLights(edit.studio, edit.light, words, [&](LightSetting& setting) {
          setting.color.kind = LightColor::Kind::Kelvin;
          setting.color.kelvin = white;
        });
      markItem(fmt::format("kelvin.{:.0f}", white));
    }
    ImGui::EndCombo();
  }
  markItem("light.kelvin.presets");
}

void green(const ColorEditor& edit) {
  const float label = px(62);
  const float room = ImGui::GetContentRegionAvail().x;
  ImGui::AlignTextToFramePadding();
  hint("Green");
  ImGui::SameLine(label);
  const auto [kelvin, duv] = correlatedTemperature(xyFromRec709(colorFactor(edit.color)));
  const bool isWhite = std::abs(duv) <= 0.05;
  const std::string words = isWhite ? fmt::format("{:+.2f}   {:.0f} K", edit.color.green, kelvin)
                                    : fmt::format("{:+.2f}   no white", edit.color.green);
  const float wordsWidth = px(110);
  float amount = edit.color.green;
  if (greenSlider("##green", &amount, room - label - wordsWidth - px(6))) {
    LightColor next = edit.color;
    next.green = amount;
    edit.preview("green", next);
  }
  markItem("light.green");
  tooltip(
      "Plus green to the right, minus green (magenta) to the left; 1 is a full correction gel. Double-click "
      "resets.");
  ImGui::SameLine(0, px(6));
  ImGui::AlignTextToFramePadding();
  hint(words);
  tooltip(
      fmt::format("Green, and the correlated colour temperature of the light. Duv {:+.4f}: its distance from "
                  "the Planckian locus (CIE 1960), positive is greener.",
                  duv)
          .c_str());
}

void gel(const ColorEditor& edit) {
  ImGui::AlignTextToFramePadding();
  hint("Gel");
  ImGui::SameLine(px(62));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (const auto chosen =
          gelCombo("##gel", edit.color.gel, edit.studio.mixer.gelFilter, edit.studio.actions)) {
    editLights(edit.studio, edit.light, chosen->empty() ? "no gel" : "gel " + *chosen,
               [&](LightSetting& setting) { setting.color.gel = *chosen; });
  }
  markItem("light.gel");
}

void heading(LightsContext& studio, size_t light, const LightSetting& setting) {
  const size_t count = lightsFor(studio, light).size();
  ImGui::PushFont(fonts().strong);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(count > 1 ? fmt::format("{} lights", count).c_str() : setting.title().c_str());
  ImGui::PopFont();
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, kFaint);
  ImGui::TextUnformatted(colorWords(setting.color).c_str());
  ImGui::PopStyleColor();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - px(16));
  if (changedDot("##reset colour", setting.color != LightColor{}, "Not white. Click to reset the colour."))
    editLights(studio, light, "reset colour", [](LightSetting& changed) { changed.color = {}; });
  markItem("light.reset_color");
}

}  // namespace

float lightPanelHeight() {
  return px(kDiscSide) + swatchRowHeight() + 4 * ImGui::GetFrameHeight() +
         6 * ImGui::GetStyle().ItemSpacing.y + px(4);
}

void drawLightPanel(LightsContext& studio) {
  if (studio.document().rig.lights.empty()) return;
  const size_t light = shownLight(studio);
  const LightSetting setting = studio.document().rig.lights[light];
  const ColorEditor edit{studio, light, setting.color};

  ImGui::PushID(static_cast<int>(light));
  heading(studio, light, setting);
  disc(edit);
  ImGui::SameLine();
  ImGui::BeginGroup();
  numbers(edit);
  settingField(edit);
  pickers(edit);
  ImGui::EndGroup();
  drawSwatchRow(studio, light, setting.color);
  temperature(edit);
  green(edit);
  gel(edit);
  ImGui::PopID();
}

}  // namespace swaplight
