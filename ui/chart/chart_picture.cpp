#include "ui/chart/chart_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kCorner = 7;      ///< radius of a corner's circle
constexpr float kGrab = 26;       ///< side of the square in which it is caught
constexpr double kReadPart = .5;  ///< of a patch's side: what is read

/// A patch, or the middle of it, in the picture.
std::array<PicturePlace, 4> patchOutline(const ChartPerspective& perspective, size_t patch, double part) {
  const ChartPlace middle = chartPatchPlace(patch);
  const double across = part * .5 / kChartWidth, down = part * .5 / kChartHeight;
  return {perspective.inPicture({middle.x - across, middle.y - down}),
          perspective.inPicture({middle.x + across, middle.y - down}),
          perspective.inPicture({middle.x + across, middle.y + down}),
          perspective.inPicture({middle.x - across, middle.y + down})};
}

/// Whether a point is within a convex outline, whichever way round.
bool within(const std::array<ImVec2, 4>& outline, ImVec2 point) {
  int left = 0;
  for (size_t j = 0; j < 4; ++j) {
    const ImVec2 a = outline[j], b = outline[(j + 1) % 4];
    left += (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x) > 0 ? 1 : 0;
  }
  return left == 0 || left == 4;
}

std::string patchWords(size_t patch, const PatchFit& fit) {
  const std::string name = chartPatchName(patch);
  if (fit.clipped) return name + ": saturated, not used";
  const std::string off = fmt::format("{}: off by {:.1f} (CIEDE2000)", name, fit.deltaE);
  return fit.outlier ? off + ", not used: glare, a shadow or a spoiled patch" : off;
}

}  // namespace

void ChartPicture::show(const SmallPicture& small, int width, int height) {
  m_texture.update(small.width, small.height, small.rgba.data());
  m_smallWidth = small.width;
  m_smallHeight = small.height;
  m_width = width;
  m_height = height;
  m_moved = false;
}

// A pixel's middle is its place.
ImVec2 ChartPicture::onScreen(const PicturePlace& place) const {
  return {m_low.x + m_scale * float(place.x + .5), m_low.y + m_scale * float(place.y + .5)};
}

void ChartPicture::drawPatches(const ChartCorners& corners, const ChartFit* fit) const {
  ImDrawList& lines = *ImGui::GetWindowDrawList();
  try {
    const ChartPerspective perspective(corners);
    for (size_t patch = 0; patch < kChartPatches; ++patch) {
      std::array<ImVec2, 4> outline;
      std::ranges::transform(patchOutline(perspective, patch, fit ? kReadPart : 1), outline.begin(),
                             [this](const PicturePlace& place) { return onScreen(place); });
      const bool used = fit && !fit->patches[patch].clipped && !fit->patches[patch].outlier;
      const ImU32 color = !fit ? kFaint : used ? kAccent : kChanged;
      // On dark patches and on bright ones.
      lines.AddPolyline(outline.data(), 4, IM_COL32(0, 0, 0, 160), ImDrawFlags_Closed, px(3.5F));
      lines.AddPolyline(outline.data(), 4, color, ImDrawFlags_Closed, px(1.5F));
      if (fit && ImGui::IsWindowHovered() && within(outline, ImGui::GetIO().MousePos))
        tooltipAtOnce(patchWords(patch, fit->patches[patch]).c_str());
    }
  } catch (const InputError&) {  // they cross: only the corners are seen
  }
}

bool ChartPicture::dragCorners(ChartCorners& corners) {
  bool letGo = false;
  for (size_t j = 0; j < 4; ++j) {
    const ImVec2 at = onScreen(corners[j]);
    ImGui::PushID(int(j));
    ImGui::SetCursorScreenPos({at.x - px(kGrab) / 2, at.y - px(kGrab) / 2});
    ImGui::InvisibleButton("##corner", {px(kGrab), px(kGrab)});
    markItem({"chart.corner.", j});
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
      const ImVec2 mouse = ImGui::GetIO().MousePos;
      const auto place = [&](float x, float low, int count) {
        return std::clamp(double((x - low) / m_scale) - .5, 0., count - 1.);
      };
      corners[j] = {place(mouse.x, m_low.x, m_width), place(mouse.y, m_low.y, m_height)};
      m_moved = true;
    }
    if (ImGui::IsItemDeactivated()) letGo = std::exchange(m_moved, false) || letGo;
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
    tooltip("Drag it onto the outer corner of the chart's corner patch; roughly will do.");
    ImDrawList& lines = *ImGui::GetWindowDrawList();
    lines.AddCircle(at, px(kCorner), IM_COL32(0, 0, 0, 200), 0, px(4));
    lines.AddCircle(at, px(kCorner), lit ? kText : kAccent, 0, px(2));
    ImGui::PopID();
  }
  return letGo;
}

bool ChartPicture::draw(ImVec2 low, ImVec2 size, ChartCorners& corners, const ChartFit* fit) {
  m_scale = std::min(size.x / float(m_width), size.y / float(m_height));
  // One to one where that is nearly so: nothing is squeezed by a few pixels.
  if (const float own = float(m_smallWidth) / float(m_width); m_scale >= own && m_scale < 1.1F * own)
    m_scale = own;
  const ImVec2 shown(std::floor(m_scale * float(m_width)), std::floor(m_scale * float(m_height)));
  m_low = {std::floor(low.x + (size.x - shown.x) / 2), std::floor(low.y + (size.y - shown.y) / 2)};
  const ImVec2 high(m_low.x + shown.x, m_low.y + shown.y);
  drawTexture(m_texture.id(), m_low, high);
  markRect("chart.picture", m_low.x, m_low.y, high.x, high.y);
  ImGui::PushClipRect(low, {low.x + size.x, low.y + size.y}, true);
  drawPatches(corners, m_moved ? nullptr : fit);
  const bool letGo = dragCorners(corners);
  ImGui::PopClipRect();
  return letGo;
}

}  // namespace swaplight
