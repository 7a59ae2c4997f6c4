#include "ui/grade/balance_wheel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include "core/color/hsv.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr int kRimSegments = 72;
constexpr float kRim = 4;    // width
constexpr float kKnob = 5;   // radius
constexpr float kStill = 2;  // around the middle: no balance, which nobody hits otherwise
constexpr float kFineDrag = 0.1F;
constexpr ImU32 kGround = IM_COL32(30, 30, 30, 255);

/// Where a channel's own hue lies: a third of a turn apart.
glm::dvec2 wayOf(size_t channel) {
  const double turn = glm::two_pi<double>() * static_cast<double>(channel) / 3;
  return {std::cos(turn), std::sin(turn)};
}

double meanOf(const std::array<double, 3>& values) {
  return (values[0] + values[1] + values[2]) / 3;
}

/// The channels' distances from their mean as a place; 1 is the rim. The three ways add up to a frame:
/// sum way way' = 3/2, so that valuesAt is its inverse.
glm::dvec2 placeOf(const std::array<double, 3>& values, double reach) {
  const double mean = meanOf(values);
  glm::dvec2 place(0);
  for (size_t c = 0; c < 3; ++c) place += (values.at(c) - mean) / reach * wayOf(c);
  return place * (2.0 / 3);
}

std::array<double, 3> valuesAt(const glm::dvec2& place, double mean, double reach) {
  std::array<double, 3> values{};
  for (size_t c = 0; c < 3; ++c) values.at(c) = mean + reach * glm::dot(place, wayOf(c));
  return values;
}

void drawWheel(const ImVec2& middle, float radius, const glm::dvec2& place, bool held) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddCircleFilled(middle, radius, kGround, kRimSegments);
  for (int i = 0; i < kRimSegments; ++i) {
    const auto angle = [](int n) {
      return glm::two_pi<float>() * static_cast<float>(n) / static_cast<float>(kRimSegments);
    };
    const Rgb codes = rgbFromHsv(Rgb(static_cast<float>(i) / kRimSegments, .75F, .85F));
    list->PathArcTo(middle, radius - px(kRim / 2), angle(i), angle(i + 1) + .01F, 3);
    list->PathStroke(colorU32(codes), 0, px(kRim));
  }
  const float arm = radius - px(kRim + 2);
  list->AddLine(ImVec2(middle.x - arm, middle.y), ImVec2(middle.x + arm, middle.y), kOutline);
  list->AddLine(ImVec2(middle.x, middle.y - arm), ImVec2(middle.x, middle.y + arm), kOutline);
  const double away = std::max(1.0, glm::length(place));  // what is beyond the rim is shown at it
  const ImVec2 knob(middle.x + static_cast<float>(place.x / away) * arm,
                    middle.y + static_cast<float>(place.y / away) * arm);
  list->AddCircleFilled(knob, px(held ? kKnob + 1.5F : kKnob), held ? kAccent : IM_COL32(214, 214, 214, 255));
  list->AddCircle(knob, px(kKnob + 1.5F), IM_COL32(0, 0, 0, 200), 0, px(1));
}

}  // namespace

bool balanceWheel(const char* id, std::array<double, 3>& values, double reach, float side) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(id, ImVec2(side, side));
  const ImVec2 middle(at.x + side / 2, at.y + side / 2);
  const float radius = side / 2 - px(1), arm = radius - px(kRim + 2);
  const bool held = ImGui::IsItemActive();
  const std::array<double, 3> before = values;
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    values = valuesAt({0, 0}, meanOf(values), reach);
  } else if (held && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
    glm::dvec2 place((io.MousePos.x - middle.x) / arm, (io.MousePos.y - middle.y) / arm);
    if (io.KeyShift)
      place = placeOf(values, reach) + glm::dvec2(io.MouseDelta.x, io.MouseDelta.y) * double{kFineDrag / arm};
    else if (glm::length(place) * arm < px(kStill))
      place = {0, 0};
    place /= std::max(1.0, glm::length(place));
    values = valuesAt(place, meanOf(values), reach);
  }
  drawWheel(middle, radius, placeOf(values, reach), held);
  return values != before;
}

}  // namespace swaplight
