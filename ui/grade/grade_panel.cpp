#include "ui/grade/grade_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/ocio/grade_file.h"
#include "ui/grade/balance_wheel.h"
#include "ui/grade/grade_edit.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kWheelSide = 96;
constexpr float kDotWidth = 16;
constexpr float kValueWidth = 92;
constexpr float kNumberWidth = 58;
constexpr std::array<const char*, 3> kChannels = {"r", "g", "b"};
constexpr std::array<ImU32, 3> kChannelInk = {IM_COL32(240, 130, 120, 255), IM_COL32(130, 215, 130, 255),
                                              IM_COL32(140, 170, 250, 255)};

/// One of the three wheels. `reach`: of a channel at the rim; `low`, `high`: of the master's slider, in codes
/// of the grading space (ACEScct: black about 0.07, middle grey 0.41, white 0.55).
struct Wheel {
  const char* name;
  const char* mark;
  const char* tip;
  std::array<double, 3> LiftGammaGain::*values;
  double neutral, reach;
  float low, high;
};
constexpr std::array<Wheel, 3> kWheels = {
    {{"Lift", "lift", "Moves the dark parts most. Drag towards a colour to tint them.", &LiftGammaGain::lift,
      0, .1, -.2F, .2F},
     {"Gamma", "gamma", "Moves what lies between dark and bright. Drag towards a colour to tint it.",
      &LiftGammaGain::gamma, 1, .3, .5F, 1.5F},
     {"Gain", "gain", "Moves the bright parts most. Drag towards a colour to tint them.",
      &LiftGammaGain::gain, 1, .3, .5F, 1.5F}}};

bool neutral(const Wheel& wheel, const std::array<double, 3>& values) {
  return std::all_of(values.begin(), values.end(),
                     [&](double v) { return std::abs(v - wheel.neutral) < 1e-9; });
}

/// To the right end of the panel, in a group too.
void toDot() {
  ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - px(kDotWidth));
}

/// All three channels by as much: a number beside the name, a slider below it.
bool master(const Wheel& wheel, std::array<double, 3>& values, float sliderWidth) {
  const double mean = (values[0] + values[1] + values[2]) / 3;
  auto shown = static_cast<float>(mean);
  ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - px(kDotWidth + 6 + kNumberWidth));
  ImGui::SetNextItemWidth(px(kNumberWidth));
  bool changed = ImGui::DragFloat("##number", &shown, static_cast<float>(wheel.reach) / 200, 0, 0, "%.3f");
  markItem({"grade.", wheel.mark, ".number"});
  tooltip("All channels. Drag, or double-click to type.");
  toDot();
  const bool reset = changedDot("##reset", !neutral(wheel, values), "Changed: click for no change.");
  markItem({"grade.", wheel.mark, ".reset"});
  ImGui::SetNextItemWidth(sliderWidth);
  changed |= ImGui::SliderFloat("##master", &shown, wheel.low, wheel.high, "", ImGuiSliderFlags_NoInput);
  markItem({"grade.", wheel.mark, ".master"});
  tooltip("All channels.");
  if (changed)
    for (double& value : values) value += shown - mean;
  if (reset) values.fill(wheel.neutral);
  return changed || reset;
}

bool channels(const Wheel& wheel, std::array<double, 3>& values) {
  const float gap = px(3);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
  bool changed = false;
  ImGui::PushFont(fonts().small);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(2), px(4)));
  for (size_t c = 0; c < 3; ++c) {
    if (c > 0) ImGui::SameLine(0, gap);
    ImGui::PushStyleColor(ImGuiCol_Text, kChannelInk.at(c));
    ImGui::SetNextItemWidth(width);
    ImGui::PushID(kChannels.at(c));
    auto shown = static_cast<float>(values.at(c));
    if (ImGui::DragFloat("##value", &shown, static_cast<float>(wheel.reach) / 200, 0, 0, "%.3f")) {
      values.at(c) = shown;
      changed = true;
    }
    ImGui::PopID();
    ImGui::PopStyleColor();
    markItem({"grade.", wheel.mark, ".", kChannels.at(c)});
    tooltip("Drag, or double-click to type.");
  }
  ImGui::PopStyleVar();
  ImGui::PopFont();
  return changed;
}

void drawWheelRow(ViewerContext& studio, const Wheel& wheel) {
  const ColorGrade grade = gradeOf(studio.document());
  LiftGammaGain all = liftGammaGainOf(grade);
  std::array<double, 3>& values = all.*wheel.values;
  const std::string step = std::string("Grade: ") + wheel.mark;
  ImGui::PushID(wheel.mark);
  bool changed = balanceWheel("##wheel", values, wheel.reach, px(kWheelSide));
  markItem({"grade.", wheel.mark});
  tooltip((std::string(wheel.tip) + " Shift drags finely, a double-click takes the tint out.").c_str());
  ImGui::SameLine(0, px(8));
  ImGui::BeginGroup();
  ImGui::Dummy(ImVec2(0, px(2)));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(wheel.name);
  changed |= master(wheel, values, ImGui::GetContentRegionMax().x - ImGui::GetCursorPosX());
  changed |= channels(wheel, values);
  ImGui::EndGroup();
  ImGui::PopID();
  if (!changed) return;
  ColorGrade graded = withLiftGammaGain(grade, all);
  graded.on = true;  // whoever grades wants to see it
  setGrade(studio.editor, step, graded, true);
}

void drawSaturation(ViewerContext& studio) {
  ColorGrade grade = gradeOf(studio.document());
  auto shown = static_cast<float>(grade.saturation);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Saturation");
  ImGui::SameLine(px(kValueWidth));
  ImGui::SetNextItemWidth(px(kNumberWidth));
  bool changed = ImGui::DragFloat("##number", &shown, .005F, 0, 0, "%.2f");
  markItem("grade.saturation.number");
  tooltip("0 is black and white, 1 changes nothing. Drag, or double-click to type.");
  ImGui::SameLine(0, px(4));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionMax().x - px(kDotWidth + 4) - ImGui::GetCursorPosX());
  changed |= ImGui::SliderFloat("##saturation", &shown, 0, 2, "", ImGuiSliderFlags_NoInput);
  markItem("grade.saturation");
  tooltip("0 is black and white, 1 changes nothing.");
  toDot();
  const bool reset =
      changedDot("##reset saturation", grade.saturation != 1, "Changed: click for 1, which changes nothing.");
  markItem("grade.saturation.reset");
  if (!changed && !reset) return;
  grade.on = true;
  grade.saturation = reset ? 1 : std::clamp<double>(shown, 0, kMostGrade);
  setGrade(studio.editor, "Grade: saturation", grade, !reset);
}

/// What a .cc file holds.
void drawNumbers(const ViewerContext& studio, const ColorGrade& grade) {
  const auto line = [](const char* name, const std::array<double, 3>& v) {
    hint(name);
    ImGui::SameLine(px(kValueWidth));
    hint(fmt::format("{:.4f}  {:.4f}  {:.4f}", v[0], v[1], v[2]));
  };
  line("Slope", grade.slope);
  line("Offset", grade.offset);
  line("Power", grade.power);
  const std::string space = studio.colors.config()->gradingSpace();
  hint("ASC CDL in " + (space == "acescct" ? "ACEScct" : space) + ", before the view");
}

void drawHeader(ViewerContext& studio, const ColorGrade& grade) {
  const float side = px(26), gap = px(4);
  ImGui::PushFont(fonts().strong);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Grade");
  ImGui::PopFont();
  tooltip("The last step of the finished frame. Hold V for the plain picture.");
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 4 * side - 3 * gap);
  const bool any = grade != ColorGrade{};
  if (toggleButton(kIconPower, any && grade.on, kAccent, side, "Grade on or off (Shift+G)"))
    studio.actions.run("grade.switch");
  markItem("grade.on");
  for (const auto& [action, icon] :
       {std::pair{"grade.reset", kIconReset}, {"grade.load", kIconOpen}, {"grade.save", kIconSave}}) {
    ImGui::SameLine(0, gap);
    actionButton(studio.actions, action, icon, side);
  }
}

}  // namespace

void drawGradePanel(ViewerContext& studio) {
  const ColorGrade grade = gradeOf(studio.document());
  drawHeader(studio, grade);
  ImGui::Dummy(ImVec2(0, px(2)));
  for (const Wheel& wheel : kWheels) drawWheelRow(studio, wheel);
  drawSaturation(studio);
  ImGui::Separator();
  drawNumbers(studio, gradeOf(studio.document()));
  markState("grade", grade == ColorGrade{} ? "none" : grade.on ? "on" : "off");
}

}  // namespace swaplight
