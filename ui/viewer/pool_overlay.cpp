#include "ui/viewer/pool_overlay.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/illumination/light_sinks.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/over_picture.h"
#include "ui/kit/theme.h"

namespace swaplight {
namespace {

constexpr ImU32 kPoolGround = IM_COL32(0, 0, 0, 170);
constexpr float kPoolMargin = 12, kArrowLength = 46, kArrowHead = 12, kMiddle = 4;  // at scale 1

class PoolPen {
 public:
  PoolPen(const ViewWindow& window, ImVec2 origin) : m_window(window), m_origin(origin) {}

  void draw(const std::string& light, const LightSink& sink, ImU32 ink, bool first) const {
    const ImVec2 at = onScreen(m_window, m_origin, sink.x, sink.y);
    const auto radius = static_cast<float>(sink.radius * m_window.zoom);
    for (const auto& [color, width] : {std::pair(kPoolGround, px(4)), std::pair(ink, px(1.6F))}) {
      ImGui::GetWindowDrawList()->AddCircle(at, radius, color, 0, width);
      ImGui::GetWindowDrawList()->AddCircleFilled(at, width + px(kMiddle - 2), color);
      if (sink.outside) arrow(at, *sink.outside, color, width);
    }
    if (at.x + radius < m_origin.x || at.x - radius > m_origin.x + static_cast<float>(m_window.width) ||
        at.y + radius < m_origin.y || at.y - radius > m_origin.y + static_cast<float>(m_window.height))
      return;  // seen by nothing of it: its words would lie at the border, about nothing there
    words(fmt::format("{}  {:.1f} stops{}", light, sink.stops, sink.outside ? ", goes on outside" : ""), at,
          ink, sink.outside);
    if (first)
      markRect({"pools.", light}, at.x - px(kMiddle), at.y - px(kMiddle), at.x + px(kMiddle),
               at.y + px(kMiddle));
  }

 private:
  /// Its tip lies where the pool leaves the picture.
  static void arrow(ImVec2 tip, const LightSink::Direction& way, ImU32 color, float width) {
    const auto x = static_cast<float>(way.x);
    const auto y = static_cast<float>(way.y);
    const auto behind = [&](float back, float aside) {
      return ImVec2(tip.x - px(back) * x - px(aside) * y, tip.y - px(back) * y + px(aside) * x);
    };
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddLine(behind(kArrowLength, 0), tip, color, width);
    draw->AddLine(behind(kArrowHead, kArrowHead / 2), tip, color, width);
    draw->AddLine(behind(kArrowHead, -kArrowHead / 2), tip, color, width);
  }

  /// Beside the middle, inside the pane.
  void words(const std::string& text, ImVec2 at, ImU32 ink,
             const std::optional<LightSink::Direction>& outside) const {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float right = m_origin.x + static_cast<float>(m_window.width) - size.x - px(kPoolMargin);
    const float bottom = m_origin.y + static_cast<float>(m_window.height) - size.y - px(kPoolMargin);
    const bool leftwards = outside && outside->x > 0.5;
    const ImVec2 place(std::clamp(leftwards ? at.x - size.x - px(10) : at.x + px(10), m_origin.x + px(8),
                                  std::max(right, m_origin.x + px(8))),
                       std::clamp(at.y + px(8), m_origin.y + px(8), std::max(bottom, m_origin.y + px(8))));
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(ImVec2(place.x - px(4), place.y - px(2)),
                        ImVec2(place.x + size.x + px(4), place.y + size.y + px(2)), kPoolGround, px(4));
    draw->AddText(place, ink, text.c_str());
  }

  const ViewWindow& m_window;
  ImVec2 m_origin;
};

std::string lampWords(const LightPools& pools) {
  if (pools.lamps == 0) return "dark";
  const std::string lamps = pools.lamps == 1 ? "1 lamp" : fmt::format("{} lamps", pools.lamps);
  return pools.sinks.empty() ? lamps + ", even" : lamps;
}

/// At the viewer's lower left corner: how many lamps each light has.
void drawLampCounts(const std::vector<std::string>& lines, const ViewWindow& window, ImVec2 origin) {
  const float row = ImGui::GetTextLineHeightWithSpacing();
  float width = 0;
  for (const std::string& line : lines) width = std::max(width, ImGui::CalcTextSize(line.c_str()).x);
  const float high = row * static_cast<float>(lines.size());
  const ImVec2 low(origin.x + px(kPoolMargin),
                   origin.y + static_cast<float>(window.height) - high - 4 * px(kPoolMargin));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, ImVec2(low.x + width + px(16), low.y + high + px(8)), kPoolGround, px(5));
  for (size_t i = 0; i < lines.size(); ++i)
    draw->AddText(ImVec2(low.x + px(8), low.y + px(4) + row * static_cast<float>(i)), kText,
                  lines[i].c_str());
  markRect("pools.legend", low.x, low.y, low.x + width + px(16), low.y + high + px(8));
}

}  // namespace

void drawPoolOverlay(ViewerContext& studio, const ViewWindow& window, ImVec2 origin) {
  if (!studio.view.pools || !studio.set()) return;
  const std::vector<LightPools>& pools = studio.subjects.pools(*studio.set(), !studio.editor.inGesture());
  const auto& lights = studio.document().rig.lights;
  if (pools.empty()) {
    if (studio.subjects.busy()) drawLampCounts({"Light pools: being found \u2026"}, window, origin);
    return;
  }
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(
      origin,
      ImVec2(origin.x + static_cast<float>(window.width), origin.y + static_cast<float>(window.height)),
      true);
  const PoolPen pen(window, origin);
  std::vector<std::string> lines;
  std::string found;
  for (size_t i = 0; i < std::min(pools.size(), lights.size()); ++i) {
    const std::string& name = lights[i].title();
    lines.push_back(name + ": " + lampWords(pools[i]));
    found += fmt::format("{}{} {}", found.empty() ? "" : ", ", lights[i].light, pools[i].lamps);
    const bool selected = static_cast<size_t>(std::max(studio.view.selectedLight, 0)) == i;
    for (const LightSink& sink : pools[i].sinks)
      pen.draw(name, sink, selected ? kAccent : kText, &sink == pools[i].sinks.data());
  }
  drawLampCounts(lines, window, origin);
  draw->PopClipRect();
  markState("viewer.pools", found);
}

}  // namespace swaplight
