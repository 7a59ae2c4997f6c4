#include "ui/scopes/scope_plots.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/color/planck.h"
#include "core/lamp/kelvin.h"
#include "ui/kit/light_words.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr ImU32 kGrid = IM_COL32(255, 255, 255, 34);
constexpr float kRoomForNames = 130;  // side of a chromaticity plot, below which names would only overlap
constexpr ImU32 kGridStrong = IM_COL32(255, 255, 255, 80);
constexpr float kLabelHeight = .8F;  // of a line of text: digits have nothing below them

/// Draws in a rectangle whose corners stand for 0, 0 (lower left) and 1, 1.
class Plot {
 public:
  Plot(ImVec2 low, ImVec2 high) : m_low(low), m_high(high), m_draw(ImGui::GetWindowDrawList()) {
    m_draw->AddRectFilled(low, high, IM_COL32(0, 0, 0, 255));
    ImGui::PushFont(fonts().small);
  }
  Plot(const Plot&) = delete;
  Plot& operator=(const Plot&) = delete;
  ~Plot() { ImGui::PopFont(); }

  [[nodiscard]] ImVec2 at(float x, float y) const {
    return {m_low.x + x * (m_high.x - m_low.x), m_high.y - y * (m_high.y - m_low.y)};
  }
  void image(unsigned texture) const { drawTexture(texture, m_low, m_high); }
  void line(float x0, float y0, float x1, float y1, ImU32 color = kGrid) const {
    m_draw->AddLine(at(x0, y0), at(x1, y1), color, std::max(1.0F, px(1)));
  }
  /// Left of the plot at a height, from below upwards. Not where the label before leaves no room.
  void labelLeft(float y, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float half = kLabelHeight * size.y / 2;
    if (at(0, y).y + half > m_writtenLeft) return;
    m_writtenLeft = at(0, y).y - half;
    m_draw->AddText(ImVec2(m_low.x - size.x - px(4), at(0, y).y - size.y / 2), kFaint, text.c_str());
  }
  /// Below the plot, from the left to the right. Not where the label before leaves no room.
  void labelBelow(float x, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    if (at(x, 0).x - size.x / 2 < m_writtenBelow) return;
    m_writtenBelow = at(x, 0).x + size.x / 2 + px(4);
    m_draw->AddText(ImVec2(at(x, 0).x - size.x / 2, m_high.y + px(2)), kFaint, text.c_str());
  }
  void label(float x, float y, const std::string& text, ImU32 color) const {
    m_draw->AddText(at(x, y), color, text.c_str());
  }
  [[nodiscard]] ImDrawList* draw() const { return m_draw; }

 private:
  ImVec2 m_low, m_high;
  float m_writtenLeft = 1e9F, m_writtenBelow = -1e9F;  ///< where the last label ends
  ImDrawList* m_draw;
};

/// The largest square in the middle of a rectangle, with room for labels.
std::pair<ImVec2, ImVec2> squareIn(ImVec2 low, ImVec2 high, float left, float below) {
  const float width = high.x - low.x - 2 * left, height = high.y - low.y - below;
  const float side = std::floor(std::max(10.0F, std::min(width, height)));
  const ImVec2 corner(std::floor(low.x + left + (width - side) / 2), std::floor(low.y + (height - side) / 2));
  return {corner, ImVec2(corner.x + side, corner.y + side)};
}

struct HistogramAxis {
  const Histogram& histogram;
  std::vector<ScopeTick> ticks;
};

HistogramAxis axisOf(const ScopePictures& pictures, ScopeOptions::Axis axis, std::vector<ScopeTick> scale) {
  std::vector<ScopeTick> ticks;
  switch (axis) {
    case ScopeOptions::Axis::Stops:
      for (int stops = int(kHistogramLowestStops); stops <= int(kHistogramHighestStops); stops += 2)
        ticks.push_back(
            {(float(stops) - kHistogramLowestStops) / (kHistogramHighestStops - kHistogramLowestStops),
             fmt::format("{:+d}", stops)});
      return {pictures.stops, ticks};
    case ScopeOptions::Axis::Linear:
      for (int half = 0; half <= int(2 * kHistogramHighestLinear); ++half)
        ticks.push_back({float(half) / (2 * kHistogramHighestLinear), fmt::format("{:.1f}", .5 * half)});
      return {pictures.linear, ticks};
    case ScopeOptions::Axis::Codes:
      break;
  }
  return {pictures.codes, std::move(scale)};
}

}  // namespace

void drawWaveform(unsigned texture, int columns, const std::vector<ScopeTick>& scale, ImVec2 low,
                  ImVec2 high) {
  Plot plot(ImVec2(low.x + px(38), low.y + px(8)), ImVec2(high.x, high.y - px(8)));
  plot.image(texture);
  for (const auto& [y, text] : scale) {
    plot.line(0, y, 1, y, y == 0 || y == 1 ? kGridStrong : kGrid);
    plot.labelLeft(y, text);
  }
  for (int i = 1; i < columns; ++i) {
    const float x = static_cast<float>(i) / static_cast<float>(columns);
    plot.line(x, 0, x, 1, kGridStrong);
  }
}

void drawVectorscope(unsigned texture, ImVec2 low, ImVec2 high) {
  const auto [from, to] = squareIn(low, high, 0, px(4));
  const Plot plot(from, to);
  plot.image(texture);
  plot.line(0, 0.5F, 1, 0.5F);
  plot.line(0.5F, 0, 0.5F, 1);
  plot.draw()->AddCircle(plot.at(0.5F, 0.5F), (to.x - from.x) / 2, kGridStrong, 64);
  const float skin = kSkinLineDegrees * std::numbers::pi_v<float> / 180;
  const float sx = 0.5F + 0.5F * std::cos(skin), sy = 0.5F + 0.5F * std::sin(skin);
  plot.line(0.5F, 0.5F, sx, sy, IM_COL32(240, 190, 150, 190));
  plot.label(sx - 0.15F, sy + 0.02F, "skin", IM_COL32(240, 190, 150, 255));
  struct Target {
    const char* name;
    Rgb code;
  };
  for (const Target& target : {Target{"R", {1, 0, 0}},
                               {"Yl", {1, 1, 0}},
                               {"G", {0, 1, 0}},
                               {"Cy", {0, 1, 1}},
                               {"B", {0, 0, 1}},
                               {"Mg", {1, 0, 1}}}) {
    const auto [x, y] = vectorscopePlace(0.75F * target.code);
    const ImVec2 at = plot.at(x, 1 - y);
    const float half = px(4);
    plot.draw()->AddRect(ImVec2(at.x - half, at.y - half), ImVec2(at.x + half, at.y + half),
                         colorU32(0.5F * target.code + Rgb(0.5F)));
    plot.draw()->AddText(ImVec2(at.x + px(6), at.y - px(8)), kFaint, target.name);
  }
}

void drawChromaticity(const std::vector<LightSetting>& lights, unsigned texture, ImVec2 low, ImVec2 high) {
  const auto [from, to] = squareIn(low, high, px(26), px(20));
  Plot plot(from, to);
  plot.image(texture);
  const auto at = [&](const Chromaticity& xy) {
    return plot.at(static_cast<float>(xy.x) / kScopeLargestX, static_cast<float>(xy.y) / kScopeLargestY);
  };
  for (int step = 0; float(step) < 5 * kScopeLargestY; ++step) {
    const float value = 0.2F * float(step);
    plot.line(0, value / kScopeLargestY, 1, value / kScopeLargestY);
    plot.labelLeft(value / kScopeLargestY, fmt::format("{:.1f}", value));
    if (value > kScopeLargestX) continue;
    plot.line(value / kScopeLargestX, 0, value / kScopeLargestX, 1);
    plot.labelBelow(value / kScopeLargestX, fmt::format("{:.1f}", value));
  }
  static const std::vector<Chromaticity> border = spectralLocus();
  std::vector<ImVec2> points;
  points.reserve(border.size());
  for (const Chromaticity& xy : border) points.push_back(at(xy));
  plot.draw()->AddPolyline(points.data(), static_cast<int>(points.size()), kGridStrong, ImDrawFlags_Closed,
                           px(1));
  points.clear();
  for (int mired = 40; mired <= 1000; mired += 20) points.push_back(at(whiteXy(1e6F / float(mired))));
  plot.draw()->AddPolyline(points.data(), static_cast<int>(points.size()), IM_COL32(240, 200, 140, 150),
                           ImDrawFlags_None, px(1));
  std::vector<ImVec2> named;
  for (const LightSetting& light : lights) {
    const ImVec2 place = at(xyFromRec709(colorFactor(light.color)));
    plot.draw()->AddCircleFilled(place, px(5), colorU32(chipColor(light.color)));
    plot.draw()->AddCircle(place, px(5), IM_COL32(0, 0, 0, 255), 0, px(2));
    plot.draw()->AddCircle(place, px(6), kText);
    if (to.x - from.x < px(kRoomForNames)) continue;
    // Names of lights of one colour stand below each other.
    ImVec2 corner(place.x + px(9), place.y - px(8));
    while (std::any_of(named.begin(), named.end(), [&](ImVec2 other) {
      return std::abs(other.x - corner.x) < px(60) && std::abs(other.y - corner.y) < px(14);
    }))
      corner.y += px(14);
    named.push_back(corner);
    plot.draw()->AddText(corner, kText, light.title().c_str());
  }
}

void drawHistogram(const ScopePictures& pictures, const ScopeOptions& options, std::vector<ScopeTick> scale,
                   ImVec2 low, ImVec2 high) {
  const HistogramAxis axis = axisOf(pictures, options.histogramAxis, std::move(scale));
  Plot plot(ImVec2(low.x + px(38), low.y + px(8)), ImVec2(high.x - px(10), high.y - px(20)));
  uint32_t most = 1;
  uint64_t pixels = 0;
  // The ends collect what lies beyond: they do not set the scale.
  for (const std::vector<uint32_t>& counts : axis.histogram.counts)
    for (size_t i = 1; i + 1 < counts.size(); ++i) most = std::max(most, counts[i]);
  for (const uint32_t count : axis.histogram.counts[3]) pixels += count;
  const auto height = [&](float count) {
    const float part = options.logCounts ? std::log1p(count) / std::log1p(static_cast<float>(most))
                                         : count / static_cast<float>(most);
    return std::min(part, 1.0F);
  };
  for (const auto& [place, text] : axis.ticks) {
    plot.line(place, 0, place, 1);
    plot.labelBelow(place, text);
  }
  const float percent = 100.0F * static_cast<float>(most) / static_cast<float>(std::max<uint64_t>(1, pixels));
  for (const float part : {0.0F, 0.5F, 1.0F}) {
    const float shown =
        options.logCounts ? std::expm1(part * std::log1p(static_cast<float>(most))) / static_cast<float>(most)
                          : part;
    plot.line(0, part, 1, part);
    plot.labelLeft(part, fmt::format("{:.1f}%", percent * shown));
  }
  constexpr std::array<ImU32, 4> inks = {IM_COL32(240, 80, 70, 255), IM_COL32(80, 220, 90, 255),
                                         IM_COL32(90, 130, 255, 255), IM_COL32(210, 210, 210, 255)};
  std::vector<ImVec2> points;
  for (size_t c = 0; c < inks.size(); ++c) {
    const std::vector<uint32_t>& counts = axis.histogram.counts[c];
    points.clear();
    for (size_t i = 0; i < counts.size(); ++i)
      points.push_back(plot.at(static_cast<float>(i) / static_cast<float>(counts.size() - 1),
                               height(static_cast<float>(counts[i]))));
    plot.draw()->AddPolyline(points.data(), static_cast<int>(points.size()), inks[c], ImDrawFlags_None,
                             px(1));
  }
}

}  // namespace swaplight
