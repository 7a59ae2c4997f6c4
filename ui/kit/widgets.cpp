#include "ui/kit/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/color/srgb.h"
#include "core/lamp/kelvin.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/tooltip_clock.h"

namespace swaplight {
namespace {

constexpr float kMiredLow = 1e6F / 20000;
constexpr float kMiredHigh = 1e6F / 1800;

// A dark or a light letter, whichever reads on this ground.
ImU32 inkOn(ImU32 ground) {
  const ImVec4 c = ImGui::ColorConvertU32ToFloat4(ground);
  return 0.3F * c.x + 0.6F * c.y + 0.1F * c.z > 0.5F ? IM_COL32(20, 20, 20, 255) : kText;
}

void drawGrab(ImVec2 low, ImVec2 high, float at, bool active) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float x = low.x + at * (high.x - low.x);
  const float half = px(4);
  draw->AddRectFilled(ImVec2(x - half, low.y + px(1)), ImVec2(x + half, high.y - px(1)),
                      active ? kAccent : IM_COL32(214, 214, 214, 255), px(3));
  draw->AddRect(ImVec2(x - half, low.y + px(1)), ImVec2(x + half, high.y - px(1)), IM_COL32(0, 0, 0, 140),
                px(3));
}

// Dear ImGui's slider with its own drawing hidden: it brings mouse, keyboard and typing.
bool bareSlider(const char* id, float* value, float low, float high, float width, const char* format) {
  for (const ImGuiCol color : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
                               ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive})
    ImGui::PushStyleColor(color, ImVec4(0, 0, 0, 0));
  ImGui::SetNextItemWidth(width);
  const bool changed = ImGui::SliderFloat(id, value, low, high, format);
  ImGui::PopStyleColor(5);
  return changed;
}

Rgb kelvinCodes(float kelvin) {
  const Rgb linear = glm::max(rec709FromXy(whiteXy(kelvin)), Rgb(0));
  return srgbFromLinear(linear / std::max({linear.r, linear.g, linear.b}));
}

/// A slider over colours; `codes` gives the colour at a value.
template <typename Codes>
bool gradientSlider(const char* id, float* value, float low, float high, float width, float height,
                    const Codes& codes) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 to(from.x + width, from.y + height);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  constexpr int kSegments = 24;
  for (int i = 0; i < kSegments; ++i) {
    const auto place = [&](int n) { return static_cast<float>(n) / kSegments; };
    const auto color = [&](int n) { return colorU32(codes(low + place(n) * (high - low))); };
    draw->AddRectFilledMultiColor(ImVec2(std::floor(from.x + place(i) * width), from.y),
                                  ImVec2(std::floor(from.x + place(i + 1) * width), to.y), color(i),
                                  color(i + 1), color(i + 1), color(i));
  }
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(ImGui::GetStyle().FramePadding.x, (height - ImGui::GetFontSize()) / 2));
  const bool changed = bareSlider(id, value, low, high, width, "");
  ImGui::PopStyleVar();
  drawGrab(ImVec2(from.x + px(5), from.y), ImVec2(to.x - px(5), to.y),
           std::clamp((*value - low) / (high - low), 0.0F, 1.0F), ImGui::IsItemActive());
  return changed;
}

}  // namespace

ImU32 colorU32(const Rgb& codes, float alpha) {
  return ImGui::ColorConvertFloat4ToU32(ImVec4(codes.r, codes.g, codes.b, alpha));
}

void drawTexture(unsigned texture, ImVec2 low, ImVec2 high) {
  if (texture == 0) return;
  const auto id = reinterpret_cast<ImTextureID>(static_cast<intptr_t>(texture));  // NOLINT: as ImGui asks
  ImGui::GetWindowDrawList()->AddImage(id, low, high);
}

void tooltipAtOnce(const char* text) {
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(px(320));
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  const ImVec2 at = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  markRect("tooltip", at.x, at.y, at.x + size.x, at.y + size.y);
  ImGui::EndTooltip();
}

void tooltip(const char* text) {
  if (!text || *text == '\0') return;
  markTip();
  if (GImGui->NavDisableMouseHover) return;  // the keyboard is in use: it would hide what is typed next
  if (tooltipDue() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) tooltipAtOnce(text);
}

bool toggleButton(const char* label, bool on, ImU32 litColor, float side, const char* tip) {
  if (on) {
    ImGui::PushStyleColor(ImGuiCol_Button, litColor);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, litColor);
    ImGui::PushStyleColor(ImGuiCol_Text, inkOn(litColor));
  }
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
  const bool clicked = ImGui::Button(label, ImVec2(side, side));
  ImGui::PopStyleVar();
  if (on) ImGui::PopStyleColor(3);
  tooltip(tip);
  return clicked;
}

bool colorChip(const char* id, const Rgb& codes, ImVec2 size, const char* tip) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton(id, size);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 high(at.x + size.x, at.y + size.y);
  draw->AddRectFilled(at, high, colorU32(codes), px(5));
  draw->AddRect(at, high, ImGui::IsItemHovered() ? kText : IM_COL32(0, 0, 0, 160), px(5), 0, px(1));
  tooltip(tip);
  return clicked;
}

bool kelvinSlider(const char* id, float* kelvin, float width) {
  // Warm is left: the slider runs over negative mired.
  float reversed = -1e6F / *kelvin;
  const bool changed = gradientSlider(id, &reversed, -kMiredHigh, -kMiredLow, width, ImGui::GetFrameHeight(),
                                      [](float at) { return kelvinCodes(-1e6F / at); });
  if (changed) *kelvin = std::round(-1e6F / reversed / 10) * 10;
  return changed;
}

bool greenSlider(const char* id, float* green, float width) {
  const auto codes = [](float at) {
    return at < 0 ? glm::mix(Rgb(0.62F), Rgb(0.80F, 0.42F, 0.74F), -at)
                  : glm::mix(Rgb(0.62F), Rgb(0.46F, 0.78F, 0.46F), at);
  };
  bool changed = gradientSlider(id, green, -1, 1, width, ImGui::GetFrameHeight(), codes);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    *green = 0;
    changed = true;
  }
  if (changed && std::abs(*green) < 0.02F) *green = 0;  // the middle holds the mouse a little
  return changed;
}

bool changedDot(const char* id, bool changed, const char* tip) {
  const float side = px(14);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  if (!changed) {
    ImGui::Dummy(ImVec2(side, height));
    return false;
  }
  const bool clicked = ImGui::InvisibleButton(id, ImVec2(side, height));
  const float radius = ImGui::IsItemHovered() ? px(5) : px(3.5F);
  ImGui::GetWindowDrawList()->AddCircleFilled(ImVec2(at.x + side / 2, at.y + height / 2), radius, kChanged);
  tooltip(tip);
  return clicked;
}

void pushChosen(bool chosen) {
  for (const ImGuiCol color : {ImGuiCol_Button, ImGuiCol_ButtonHovered})
    ImGui::PushStyleColor(color,
                          chosen ? ImGui::ColorConvertU32ToFloat4(kAccent) : ImGui::GetStyleColorVec4(color));
}

void popChosen() {
  ImGui::PopStyleColor(2);
}

void hint(const std::string& text) {
  ImGui::PushFont(fonts().small);
  ImGui::PushStyleColor(ImGuiCol_Text, kFaint);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

std::string cutToWidth(const std::string& text, float width) {
  const auto widthOf = [](const std::string& words) { return ImGui::CalcTextSize(words.c_str()).x; };
  if (widthOf(text) <= width) return text;
  std::string cut = text;
  do {
    while (!cut.empty() && (cut.back() & 0xC0) == 0x80) cut.pop_back();  // the rest of a letter
    if (!cut.empty()) cut.pop_back();
    while (!cut.empty() && cut.back() == ' ') cut.pop_back();
  } while (!cut.empty() && widthOf(cut + "\u2026") > width);
  return cut.empty() && widthOf("\u2026") > width ? cut : cut + "\u2026";
}

void splitter(const char* id, bool vertical, float thickness, float extent, float* length, float low,
              float high, float sign) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size = vertical ? ImVec2(thickness, extent) : ImVec2(extent, thickness);
  ImGui::InvisibleButton(id, size);
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (lit) ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  if (ImGui::IsItemActive()) {
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    *length = std::clamp(*length + sign * (vertical ? delta.x : delta.y) / px(100) * 100, low, high);
  }
  ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + size.x, at.y + size.y),
                                            lit ? kAccent : IM_COL32(20, 20, 20, 255));
}

}  // namespace swaplight
