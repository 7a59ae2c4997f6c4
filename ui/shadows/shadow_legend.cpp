#include "ui/shadows/shadow_legend.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "ui/kit/layout_probe.h"
#include "ui/kit/over_picture.h"
#include "ui/kit/theme.h"
#include "ui/shadows/shadow_colors.h"

namespace swaplight {
namespace {

constexpr float kSampleLeft = 8, kSampleRight = 30, kWordsLeft = 38;  // at scale 1, from the legend's corner
constexpr float kMarkRadius = 5;

struct Row {
  const char* words;
  const char* tip;
  std::function<void(ImVec2 left, ImVec2 right)> sample;
};

void sampleLine(ImVec2 left, ImVec2 right, ImU32 ink, float width, bool ticks) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddLine(left, right, ink, px(width));
  for (const float x : {6.F, 14.F})
    if (ticks)
      draw->AddLine(ImVec2(left.x + px(x), left.y), ImVec2(left.x + px(x), left.y + px(5)), ink, px(1));
}

void sampleHatch(ImVec2 left, ImVec2 right) {
  drawHatch(ImVec2(left.x, left.y - px(6)), ImVec2(right.x, right.y + px(6)), kUntoldInk,
            [](float, float) { return true; });
}

std::vector<Row> rowsOf(const ShadowLegend& legend) {
  std::vector<Row> rows;
  if (legend.outlines) {
    rows.push_back({"umbra: none of the light", "The light does not reach what this line encloses.",
                    [](ImVec2 a, ImVec2 b) { sampleLine(a, b, kUmbraInk, 2, false); }});
    rows.push_back({"penumbra: part of it", "Part of the light reaches what lies inside this line.",
                    [](ImVec2 a, ImVec2 b) { sampleLine(a, b, kPenumbraInk, 1.5F, true); }});
  }
  if (legend.untold)
    rows.push_back(
        {"cannot be told",
         "Shadow or dim light: the light is too weak here, or both look alike. Counts as lit. Take "
         "\"This is shadow\" or \"This is lit\" and click here.",
         sampleHatch});
  if (legend.chosen)
    rows.push_back({"the selected shadow", "What the sliders change.",
                    [](ImVec2 a, ImVec2 b) { sampleLine(a, b, kChosenInk, 3, true); }});
  if (legend.marks)
    rows.push_back({"labelled shadow, lit",
                    "What you said of a place. Click it again with the same tool to take it back.",
                    [](ImVec2 a, ImVec2 b) {
                      drawShadowMark(ShadowMark::Kind::Shadow, ImVec2(a.x + px(4), a.y));
                      drawShadowMark(ShadowMark::Kind::Lit, ImVec2(b.x - px(3), b.y));
                    }});
  return rows;
}

}  // namespace

void drawShadowMark(ShadowMark::Kind kind, ImVec2 at) {
  const bool lit = kind == ShadowMark::Kind::Lit;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddCircleFilled(at, px(kMarkRadius + 2), IM_COL32(0, 0, 0, 170));
  draw->AddCircleFilled(at, px(kMarkRadius), lit ? IM_COL32(255, 250, 235, 255) : IM_COL32(16, 18, 22, 255));
  draw->AddCircle(at, px(kMarkRadius), lit ? IM_COL32(16, 18, 22, 255) : kUmbraInk, 0, px(1.6F));
}

void drawShadowLegend(const ShadowLegend& legend, ImVec2 origin, ImVec2 size) {
  const std::vector<Row> rows = rowsOf(legend);
  ImGui::PushFont(fonts().small);
  const float line = ImGui::GetTextLineHeight();
  const float row = line + px(4);
  float width = 0;
  for (const Row& one : rows) width = std::max(width, ImGui::CalcTextSize(one.words).x);
  const ImVec2 high(origin.x + size.x - px(12), origin.y + size.y - px(12));
  const ImVec2 low(high.x - width - px(kWordsLeft + 10),
                   high.y - row * static_cast<float>(rows.size()) - px(10));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, IM_COL32(0, 0, 0, 200), px(5));
  const char* tip = nullptr;
  for (size_t i = 0; i < rows.size(); ++i) {
    const float y = low.y + px(6) + row * static_cast<float>(i);
    rows[i].sample(ImVec2(low.x + px(kSampleLeft), y + line / 2),
                   ImVec2(low.x + px(kSampleRight), y + line / 2));
    draw->AddText(ImVec2(low.x + px(kWordsLeft), y), kText, rows[i].words);
    if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(ImVec2(low.x, y), ImVec2(high.x, y + row)))
      tip = rows[i].tip;
  }
  ImGui::PopFont();
  if (tip) tooltipAtOnce(tip);  // nothing here is clicked that it could hide
  markRect("shadows.legend", low.x, low.y, high.x, high.y);
}

}  // namespace swaplight
