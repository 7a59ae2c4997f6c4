#include "ui/curve/curve_widget.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/curve.h"
#include "core/base/error.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kReach = 9;           ///< of a point, pixels at scale 1
constexpr float kOutside = 26;        ///< beyond the area a point is let go
constexpr float kLeastApart = .005F;  // in x
constexpr int kSteps = 96;
constexpr size_t kFewest = 2;

/// The area on the screen; beta 1 is at the top.
struct PlotArea {
  ImVec2 low, high;
  float most = 1;  ///< the largest beta shown
  [[nodiscard]] ImVec2 at(float x, float y) const {
    return {low.x + x * (high.x - low.x), high.y - y / most * (high.y - low.y)};
  }
  [[nodiscard]] std::array<float, 2> valueAt(ImVec2 p) const {
    return {std::clamp((p.x - low.x) / (high.x - low.x), 0.F, 1.F),
            std::clamp((high.y - p.y) / (high.y - low.y), 0.F, 1.F) * most};
  }
  [[nodiscard]] bool farOutside(ImVec2 p) const {
    const float air = px(kOutside);
    return p.x < low.x - air || p.x > high.x + air || p.y < low.y - air || p.y > high.y + air;
  }
};

int pointAt(const CurvePoints& points, const PlotArea& area, ImVec2 mouse) {
  for (size_t i = 0; i < points.size(); ++i) {
    const ImVec2 at = area.at(points[i][0], points[i][1]);
    if (std::hypot(at.x - mouse.x, at.y - mouse.y) < px(kReach)) return static_cast<int>(i);
  }
  return -1;
}

/// Where a new point would go; the place of the first point right of it.
int insertPoint(CurvePoints& points, const std::array<float, 2>& value) {
  const auto right =
      std::find_if(points.begin(), points.end(), [&](const auto& point) { return point[0] > value[0]; });
  const bool apart = (right == points.end() || right->at(0) - value[0] > kLeastApart) &&
                     (right == points.begin() || value[0] - std::prev(right)->at(0) > kLeastApart);
  if (!apart) return -1;
  const auto place = static_cast<int>(right - points.begin());
  points.insert(right, value);
  return place;
}

/// The points with the held one at the mouse, between its neighbours; without it where the mouse is far away.
CurvePoints dragged(const CurveGrab& grab, const PlotArea& area, ImVec2 mouse) {
  CurvePoints points = grab.before;
  const auto held = static_cast<size_t>(grab.held);
  if (area.farOutside(mouse) && points.size() > kFewest) {
    points.erase(points.begin() + grab.held);
    return points;
  }
  std::array<float, 2> value = area.valueAt(mouse);
  const float least = held > 0 ? points[held - 1][0] + kLeastApart : 0;
  const float most = held + 1 < points.size() ? points[held + 1][0] - kLeastApart : 1;
  value[0] = std::clamp(value[0], std::min(least, most), std::max(least, most));
  points[held] = value;
  return points;
}

void drawPlotArea(const PlotArea& area, std::span<const float> histogram) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(area.low, area.high, kViewerGround);
  const float width = (area.high.x - area.low.x) / static_cast<float>(std::max<size_t>(1, histogram.size()));
  for (size_t i = 0; i < histogram.size(); ++i) {
    const float x = area.low.x + static_cast<float>(i) * width;
    draw->AddRectFilled(ImVec2(x, area.high.y - histogram[i] * (area.high.y - area.low.y)),
                        ImVec2(x + width, area.high.y), IM_COL32(110, 110, 110, 130));
  }
  for (const float part : {0.25F, 0.5F, 0.75F}) {
    draw->AddLine(area.at(part, 0), area.at(part, area.most), IM_COL32(255, 255, 255, 22));
    draw->AddLine(area.at(0, part * area.most), area.at(1, part * area.most), IM_COL32(255, 255, 255, 22));
  }
  draw->AddLine(area.at(0, 0), area.at(1, 1), IM_COL32(255, 255, 255, 46));
  draw->AddRect(area.low, area.high, kOutline);
}

void drawCurve(const CurvePoints& points, const PlotArea& area, int lit, const std::string& name) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  std::vector<ImVec2> line;
  try {
    const std::vector<float> table = curveTable(points, kSteps + 1);
    for (int i = 0; i <= kSteps; ++i)
      line.push_back(
          area.at(static_cast<float>(i) / kSteps, std::min(table[static_cast<size_t>(i)], area.most)));
  } catch (const InputError&) {
    line.clear();  // a file's points may be anything
  }
  draw->PushClipRect(area.low, area.high, true);
  draw->AddPolyline(line.data(), static_cast<int>(line.size()), kAccent, ImDrawFlags_None, px(2));
  draw->PopClipRect();
  for (size_t i = 0; i < points.size(); ++i) {
    const ImVec2 at = area.at(points[i][0], std::min(points[i][1], area.most));
    const bool big = static_cast<int>(i) == lit;
    draw->AddCircleFilled(at, px(big ? 5.5F : 4.F), big ? kAccent : kText);
    draw->AddCircle(at, px(big ? 5.5F : 4.F), IM_COL32(0, 0, 0, 200), 0, px(1));
    markRect({name + ".point.", i}, at.x - px(4), at.y - px(4), at.x + px(4), at.y + px(4));
  }
}

}  // namespace

bool curveWidget(CurvePoints& points, CurveGrab& grab, const CurveLook& look) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size = look.size;
  ImGui::InvisibleButton("##curve", size);
  markItem(look.name);
  // Points on the border can be taken hold of as well.
  const float air = px(5);
  PlotArea area{ImVec2(corner.x + air, corner.y + air),
                ImVec2(corner.x + size.x - air, corner.y + size.y - air)};
  for (const auto& point : points) area.most = std::max(area.most, point[1]);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const int under = ImGui::IsItemHovered() || ImGui::IsItemActive() ? pointAt(points, area, mouse) : -1;

  bool changed = false;
  if (ImGui::IsItemActivated()) {
    grab.before = points;
    grab.held = under;
    const bool removes = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && under >= 0;
    if (removes && points.size() > kFewest) {
      points.erase(points.begin() + under);
      grab.held = -1;
      changed = true;
    } else if (removes) {
      grab.held = -1;
    } else if (under < 0 && points.size() < look.mostPoints) {
      grab.held = insertPoint(grab.before, area.valueAt(mouse));
    }
  }
  const bool isNew = grab.held >= 0 && grab.before.size() > points.size() && !ImGui::GetIO().MouseReleased[0];
  const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, px(2));
  if (ImGui::IsItemActive() && grab.held >= 0 && (isNew || moved.x != 0 || moved.y != 0)) {
    const CurvePoints next = dragged(grab, area, mouse);
    changed = changed || next != points;
    points = next;
  }
  if (!ImGui::IsItemActive()) grab.held = -1;
  drawPlotArea(area, look.histogram);
  drawCurve(points, area, ImGui::IsItemActive() ? grab.held : under, look.name);
  if (!ImGui::IsItemActive())
    tooltip((look.tip + "\nClick to add a point, drag to move it, double-click or drag it out to remove it.")
                .c_str());
  return changed;
}

}  // namespace swaplight
