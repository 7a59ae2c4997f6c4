#include "ui/kit/panel_controls.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {

bool choiceButton(const char* words, bool chosen, float width, const char* mark, const char* tip) {
  pushChosen(chosen);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(2), ImGui::GetStyle().FramePadding.y));
  ImGui::PushID(mark);
  const bool clicked = ImGui::Button(words, ImVec2(width, 0));
  ImGui::PopID();
  ImGui::PopStyleVar();
  popChosen();
  markItem(mark);
  tooltip(tip);
  return clicked;
}

namespace {

/// The format, or the text itself where it would be a zero with a minus: "-0 degrees".
std::string formatWithoutMinusZero(const char* format, float value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format,
                double{value});  // NOLINT(cppcoreguidelines-pro-type-vararg)
  if (text[0] != '-' || std::strtof(text.data(), nullptr) != 0) return format;
  std::string literal;
  for (const char* c = text.data() + 1; *c != 0; ++c) literal += *c == '%' ? "%%" : std::string(1, *c);
  return literal;
}

}  // namespace

bool labelledSlider(const char* label, const char* mark, float* value, float low, float high,
                    const char* format, const char* tip, ImGuiSliderFlags flags) {
  ImGui::AlignTextToFramePadding();
  hint(label);
  ImGui::SameLine(px(kLabelWidth));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  const std::string id = std::string("##") + mark;
  const bool changed =
      ImGui::SliderFloat(id.c_str(), value, low, high, formatWithoutMinusZero(format, *value).c_str(), flags);
  markItem(mark);
  tooltip(tip);
  return changed;
}

bool percentSlider(const char* label, const char* mark, float* part, float most, const char* tip) {
  float percent = 100 * *part;
  if (!labelledSlider(label, mark, &percent, 0, most, "%.0f %%", tip)) return false;
  *part = percent / 100;
  return true;
}

}  // namespace swaplight
