#include "ui/light_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <glm/common.hpp>

#include "core/color/srgb.h"
#include "core/error.h"
#include "core/relight/setting.h"
#include "ui/icons.h"
#include "ui/layout_probe.h"
#include "ui/light_edit.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace swaplight {
namespace {

constexpr float kWheelSide = 186;

LightColor hexColor(const Rgb& codes) {
  LightColor color;
  color.kind = LightColor::Kind::Hex;
  color.value = glm::clamp(codes, Rgb(0), Rgb(1));
  return color;
}

void wheel(StudioContext& studio, size_t index, LightSetting setting) {
  Rgb codes = setting.color.kind == LightColor::Kind::Hex ? setting.color.value : chipColor(setting.color);
  ImGui::SetNextItemWidth(px(kWheelSide));
  constexpr ImGuiColorEditFlags flags =
      ImGuiColorEditFlags_PickerHueWheel | ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoInputs |
      ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoAlpha | ImGuiColorEditFlags_NoOptions;
  if (ImGui::ColorPicker3("##wheel", &codes.x, flags)) {
    setting.color = hexColor(codes);
    previewLight(studio, index, "colour", setting);
  }
  markItem("light.wheel");
}

void numbers(StudioContext& studio, size_t index, LightSetting setting) {
  Rgb codes = setting.color.kind == LightColor::Kind::Hex ? setting.color.value : chipColor(setting.color);
  constexpr ImGuiColorEditFlags common = ImGuiColorEditFlags_NoSmallPreview | ImGuiColorEditFlags_NoAlpha |
                                         ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoOptions;
  const float width = ImGui::GetContentRegionAvail().x;
  for (const ImGuiColorEditFlags kind : {ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_Uint8,
                                         ImGuiColorEditFlags_DisplayHSV | ImGuiColorEditFlags_Uint8}) {
    ImGui::SetNextItemWidth(width);
    ImGui::PushID(static_cast<int>(kind));
    if (ImGui::ColorEdit3("##numbers", &codes.x, common | kind)) {
      setting.color = hexColor(codes);
      previewLight(studio, index, "colour", setting);
    }
    ImGui::PopID();
  }
  std::string text = hexText(codes);
  text.resize(16, '\0');
  ImGui::SetNextItemWidth(width);
  if (ImGui::InputText("##hex", text.data(), text.size(),
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll)) {
    try {
      applySetting(setting, text.c_str());
      editLight(studio, index, text.c_str(), setting);
    } catch (const InputError& error) {
      studio.messages.error(error.what());
    }
  }
  markItem("light.hex");
  tooltip("The colour as sRGB codes, or any setting: 3200K, rgb:1/0.5/0.2, gel:L201, +1st.");
}

void temperature(StudioContext& studio, size_t index, LightSetting setting) {
  const float numberWidth = px(84);
  const float width = ImGui::GetContentRegionAvail().x - numberWidth - ImGui::GetStyle().ItemSpacing.x;
  const auto show = [&](float kelvin) {
    setting.color.kind = LightColor::Kind::Kelvin;
    setting.color.kelvin = std::clamp(kelvin, 1000.0F, 25000.0F);
    previewLight(studio, index, "temperature", setting);
  };
  float kelvin = setting.color.kelvin;
  if (kelvinSlider("##kelvin", &kelvin, width)) show(kelvin);
  markItem("light.kelvin");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(numberWidth);
  const bool isKelvin = setting.color.kind == LightColor::Kind::Kelvin;
  if (!isKelvin) ImGui::PushStyleColor(ImGuiCol_Text, kFaint);
  if (ImGui::DragFloat("##kelvin number", &kelvin, 10, 1000, 25000, "%.0f K")) show(kelvin);
  if (!isKelvin) ImGui::PopStyleColor();
  markItem("light.kelvin.number");
  tooltip("Double-click to type.");
}

}  // namespace

float lightPanelHeight() {
  return px(kWheelSide) + 3 * ImGui::GetFrameHeightWithSpacing() + px(16);
}

void drawLightPanel(StudioContext& studio) {
  const Rig& rig = studio.document().rig;
  if (rig.lights.empty()) return;
  const size_t index =
      std::min(static_cast<size_t>(std::max(0, studio.view.selectedLight)), rig.lights.size() - 1);
  const LightSetting setting = rig.lights[index];

  ImGui::PushID(static_cast<int>(index));
  ImGui::PushFont(fonts().strong);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(setting.light.c_str());
  ImGui::PopFont();
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, kFaint);
  ImGui::TextUnformatted(colorWords(setting.color).c_str());
  ImGui::PopStyleColor();

  wheel(studio, index, setting);
  ImGui::SameLine();
  ImGui::BeginGroup();
  numbers(studio, index, setting);
  ImGui::EndGroup();
  temperature(studio, index, setting);
  ImGui::PopID();
}

}  // namespace swaplight
