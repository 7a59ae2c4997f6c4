#pragma once

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "core/view/view_window.h"
#include "ui/kit/theme.h"

// What is drawn over the picture in the viewer.

namespace swaplight {

/// The point of the screen that shows a picture's point (x, y), in pixels of the picture; `origin`: the upper
/// left corner of the viewer.
[[nodiscard]] inline ImVec2 onScreen(const ViewWindow& window, ImVec2 origin, double x, double y) {
  return {origin.x + static_cast<float>(window.windowX(x)), origin.y + static_cast<float>(window.windowY(y))};
}

/// Hatches a part of a rectangle of the screen, what is a guess: rising lines wherever inside(x, y) holds.
/// They stay where they are while that part changes.
template <typename Inside>
void drawHatch(ImVec2 low, ImVec2 high, ImU32 color, const Inside& inside) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float apart = px(9);
  const float step = px(3);
  const float height = high.y - low.y;
  for (float begin = low.x - height; begin < high.x; begin += apart) {
    // From the lower edge at `begin` up and to the right; `from` is where the piece that is being drawn
    // began.
    float from = -1;
    const auto at = [&](float t) { return ImVec2(begin + t, high.y - t); };
    const float last = std::min(height, high.x - begin);
    for (float t = std::max(0.F, low.x - begin); t < last + step; t += step) {
      const bool in = t < last && inside(at(t).x, at(t).y);
      if (in && from < 0) from = t;
      if (!in && from >= 0) {
        for (const auto& [ink, thick] :
             {std::pair(IM_COL32(0, 0, 0, 120), px(2.2F)), std::pair(color, px(1.2F))})
          draw->AddLine(at(from), at(std::min(t, last)), ink, thick);
        from = -1;
      }
    }
  }
}

}  // namespace swaplight
