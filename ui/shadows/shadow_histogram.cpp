#include "ui/shadows/shadow_histogram.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/shadows/shadow_colors.h"

namespace swaplight {
namespace {

constexpr float kLow = ShadowHistogram::kLowestStops, kHigh = ShadowHistogram::kHighestStops;
constexpr int kTickStops = 2;

/// Where things lie in the plot.
struct Plot {
  ImVec2 low, high;
  [[nodiscard]] float x(float stops) const {
    return low.x + (stops - kLow) / (kHigh - kLow) * (high.x - low.x);
  }
  [[nodiscard]] float stopsAt(float x) const {
    return kLow + (x - low.x) / (high.x - low.x) * (kHigh - kLow);
  }
};

/// What is surely in shadow, surely lit, and what the edges decide.
ImU32 inkAt(float stops, float threshold) {
  if (stops < threshold - surelyShadowStops()) return kUmbraInk;
  return stops < threshold + surelyLitStops() ? kPenumbraInk : IM_COL32(190, 190, 190, 255);
}

void drawBars(const ShadowHistogram& histogram, float threshold, const Plot& plot) {
  // The ends collect what lies beyond: they do not set the scale. Roots, so that small shadows are seen.
  const float most = *std::max_element(histogram.share.begin() + 1, histogram.share.end() - 1);
  for (size_t i = 0; i < ShadowHistogram::kBins; ++i) {
    const auto edge = [&](size_t bin) {
      return kLow + static_cast<float>(bin) / ShadowHistogram::kBins * (kHigh - kLow);
    };
    const float part = std::sqrt(std::min(histogram.share.at(i) / std::max(most, 1e-6F), 1.0F));
    ImGui::GetWindowDrawList()->AddRectFilled(
        ImVec2(plot.x(edge(i)), plot.high.y - part * (plot.high.y - plot.low.y)),
        ImVec2(plot.x(edge(i + 1)), plot.high.y), inkAt((edge(i) + edge(i + 1)) / 2, threshold));
  }
}

void drawAxis(const Plot& plot) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (int stops = static_cast<int>(kLow) + kTickStops; stops < static_cast<int>(kHigh);
       stops += kTickStops) {
    const float x = plot.x(static_cast<float>(stops));
    draw->AddLine(ImVec2(x, plot.low.y), ImVec2(x, plot.high.y), IM_COL32(255, 255, 255, 24));
    const std::string words = stops == 0 ? "lit" : fmt::format("{:+d}", stops);
    draw->AddText(ImVec2(x - ImGui::CalcTextSize(words.c_str()).x / 2, plot.high.y + px(1)), kFaint,
                  words.c_str());
  }
}

void drawThreshold(float x, const Plot& plot, bool held) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 ink = held ? kAccent : kText;
  draw->AddLine(ImVec2(x, plot.low.y), ImVec2(x, plot.high.y), IM_COL32(0, 0, 0, 200), px(4));
  draw->AddLine(ImVec2(x, plot.low.y), ImVec2(x, plot.high.y), ink, px(2));
  draw->AddTriangleFilled(ImVec2(x - px(6), plot.low.y), ImVec2(x + px(6), plot.low.y),
                          ImVec2(x, plot.low.y + px(8)), ink);
}

}  // namespace

std::optional<float> shadowHistogram(const ShadowHistogram& histogram, float threshold, ImVec2 size) {
  ImGui::PushFont(fonts().small);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float axis = ImGui::GetTextLineHeight() + px(2);
  const Plot plot{at, ImVec2(at.x + size.x, at.y + size.y - axis)};
  ImGui::InvisibleButton("##threshold", size);
  const bool held = ImGui::IsItemActive();
  if (ImGui::IsItemHovered() || held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  markItem("shadows.histogram");

  ImGui::GetWindowDrawList()->AddRectFilled(plot.low, plot.high, kViewerGround);
  const float stops = std::clamp(stopsFromThreshold(threshold), kLow, kHigh);
  drawBars(histogram, stops, plot);
  drawAxis(plot);
  drawThreshold(plot.x(stops), plot, held);
  ImGui::PopFont();
  markRect("shadows.threshold", plot.x(stops) - px(4), plot.low.y, plot.x(stops) + px(4), plot.high.y);
  tooltip(
      "Histogram of the light in stops below fully lit, with surface brightness mostly removed. Drag the "
      "line to set where shadow begins; in between, the shadows' edges decide.");
  if (!held) return std::nullopt;
  const float moved = std::clamp(plot.stopsAt(ImGui::GetIO().MousePos.x), kLow + 0.1F, -0.05F);
  return std::abs(moved - stops) < 1e-4F ? std::nullopt : std::optional(thresholdFromStops(moved));
}

}  // namespace swaplight
