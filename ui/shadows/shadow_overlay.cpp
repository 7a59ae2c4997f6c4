#include "ui/shadows/shadow_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/control/shadow_edit.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/over_picture.h"
#include "ui/kit/theme.h"
#include "ui/shadows/shadow_colors.h"
#include "ui/shadows/shadow_legend.h"

namespace swaplight {
namespace {

constexpr size_t kPointsAtOnce = 2000;               // Dear ImGui counts a line's corners in 16 bits
constexpr float kLeastStep = 1.5F;                   // pixels of the screen between two points that are drawn
constexpr float kTickSpacing = 11, kTickLength = 6;  // at scale 1

/// Draws outlines of the picture where they are seen.
class OutlinePen {
 public:
  OutlinePen(const ViewWindow& window, ImVec2 origin)
      : m_window(window),
        m_low(origin),
        m_high(origin.x + static_cast<float>(window.width), origin.y + static_cast<float>(window.height)) {}

  void draw(const std::vector<Outline>& outlines, ImU32 ink, float width) {
    // All of the dark ground first: a line would else cross its neighbours' light.
    for (const auto& [color, thick] :
         {std::pair(IM_COL32(0, 0, 0, 170), width + px(2)), std::pair(ink, width)})
      for (const Outline& outline : outlines) drawOne(outline, color, thick);
  }

  /// Fainter than the line itself: which side of it is shadow.
  void drawTicks(const std::vector<Outline>& outlines, ImU32 ink) {
    const auto zoom = static_cast<float>(m_window.zoom);
    const ImU32 faint = (ink & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 150);
    for (const Outline& outline : outlines)
      for (const auto& [from, to] : shadowTicks(outline, px(kTickSpacing) / zoom, px(kTickLength) / zoom)) {
        const ImVec2 foot = shown(from);
        if (foot.x > m_low.x && foot.x < m_high.x && foot.y > m_low.y && foot.y < m_high.y)
          ImGui::GetWindowDrawList()->AddLine(foot, shown(to), faint, px(1.2F));
      }
  }

 private:
  [[nodiscard]] ImVec2 shown(const std::array<float, 2>& point) const {
    return onScreen(m_window, m_low, point[0], point[1]);
  }

  void drawOne(const Outline& outline, ImU32 color, float width) {
    m_line.clear();
    for (size_t i = 0; i <= outline.size(); ++i) {
      const ImVec2 at = shown(outline[i % outline.size()]);
      const bool near = !m_line.empty() && std::abs(at.x - m_line.back().x) < kLeastStep &&
                        std::abs(at.y - m_line.back().y) < kLeastStep;
      if (near && i < outline.size()) continue;
      m_line.push_back(at);
      if (m_line.size() == kPointsAtOnce) flush(color, width, true);
    }
    flush(color, width, false);
  }

  void flush(ImU32 color, float width, bool goesOn) {
    const auto [left, right] =
        std::minmax_element(m_line.begin(), m_line.end(), [](ImVec2 a, ImVec2 b) { return a.x < b.x; });
    const auto [top, bottom] =
        std::minmax_element(m_line.begin(), m_line.end(), [](ImVec2 a, ImVec2 b) { return a.y < b.y; });
    const bool seen = left->x < m_high.x && right->x > m_low.x && top->y < m_high.y && bottom->y > m_low.y;
    if (seen)
      ImGui::GetWindowDrawList()->AddPolyline(m_line.data(), static_cast<int>(m_line.size()), color,
                                              ImDrawFlags_None, width);
    const ImVec2 last = m_line.back();
    m_line.clear();
    if (goesOn) m_line.push_back(last);
  }

  const ViewWindow& m_window;
  ImVec2 m_low, m_high;
  std::vector<ImVec2> m_line;
};

void hatch(const UntoldPixels& untold, const ViewWindow& window, ImVec2 origin) {
  if (untold.share() == 0) return;
  drawHatch(origin,
            ImVec2(origin.x + static_cast<float>(window.width), origin.y + static_cast<float>(window.height)),
            kUntoldInk, [&](float x, float y) {
              return untold.at(static_cast<float>(window.pictureX(double{x} - origin.x)),
                               static_cast<float>(window.pictureY(double{y} - origin.y)));
            });
}

void drawMarks(const ShadowMarks& marks, const ViewWindow& window, ImVec2 origin) {
  for (size_t i = 0; i < marks.size(); ++i) {
    const ImVec2 at = onScreen(window, origin, marks[i].x + .5, marks[i].y + .5);
    drawShadowMark(marks[i].is, at);
    markRect({"shadows.mark.", std::to_string(i)}, at.x - px(4), at.y - px(4), at.x + px(4), at.y + px(4));
  }
}

}  // namespace

void drawShadowOverlay(EditingContext& studio, const ViewWindow& window, ImVec2 origin, ImVec2 size) {
  if (!shadowsShown(studio)) return;
  const ShadowState& state = studio.editing.shadow;
  const ShadowController::Shown* shown = state.outlines ? studio.shadows.shown() : nullptr;
  const ShadowMarks& marks = shadowMarksOf(studio.document(), shownShadowLight(studio));
  const bool chosen = state.chosen.has_value();
  if (!chosen && !shown && marks.empty()) return;
  ImGui::GetWindowDrawList()->PushClipRect(
      origin,
      ImVec2(origin.x + static_cast<float>(window.width), origin.y + static_cast<float>(window.height)),
      true);
  OutlinePen pen(window, origin);
  if (shown) {
    hatch(shown->untold, window, origin);
    pen.drawTicks(shown->outlines.penumbra, kPenumbraInk);
    pen.draw(shown->outlines.penumbra, kPenumbraInk, px(1.2F));
    pen.draw(shown->outlines.umbra, kUmbraInk, px(1.6F));
  }
  if (chosen) {
    pen.drawTicks(state.chosen->outline, kChosenInk);
    pen.draw(state.chosen->outline, kChosenInk, px(2.6F));
  }
  drawMarks(marks, window, origin);
  ImGui::GetWindowDrawList()->PopClipRect();
  drawShadowLegend({shown != nullptr, shown && shown->untold.share() > 0, chosen, !marks.empty()}, origin,
                   size);
  markState("shadows.outlines", shown ? "drawn" : "none");
}

}  // namespace swaplight
