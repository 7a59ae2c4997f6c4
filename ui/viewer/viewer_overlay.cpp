#include "ui/viewer/viewer_overlay.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/plot/color_map.h"
#include "core/view/display/false_color.h"
#include "core/view/subject_image.h"
#include "ui/control/viewer_request.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/over_picture.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/shadows/shadow_overlay.h"
#include "ui/tools/picture_tool.h"
#include "ui/viewer/pool_overlay.h"
#include "ui/viewer/viewer_mouse.h"

namespace swaplight {
namespace {

constexpr ImU32 kGround = IM_COL32(0, 0, 0, 170);
constexpr ImU32 kLine = IM_COL32(255, 255, 255, 220);
constexpr float kMargin = 12;

/// Text on a dark ground; returns its size.
ImVec2 label(const std::string& text, ImVec2 at, ImU32 color, bool outlined = false) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 words = ImGui::CalcTextSize(text.c_str());
  const ImVec2 size(words.x + px(16), words.y + px(8));
  const ImVec2 high(at.x + size.x, at.y + size.y);
  draw->AddRectFilled(at, high, kGround, px(5));
  if (outlined) draw->AddRect(at, high, color, px(5));
  draw->AddText(ImVec2(at.x + px(8), at.y + px(4)), color, text.c_str());
  return size;
}

std::string badgeText(const ViewSettings& settings) {
  std::string text;
  if (settings.exposureStops != 0) text += fmt::format("viewer {:+.2f} st", settings.exposureStops);
  if (settings.gamma != 1)
    text += fmt::format("{}gamma {:.2f}", text.empty() ? "viewer " : "  ", settings.gamma);
  constexpr std::array<const char*, 5> channels = {"", "red", "green", "blue", "luminance"};
  const char* channel = channels[static_cast<size_t>(settings.channel)];
  if (*channel != '\0') text += (text.empty() ? "" : "  ") + std::string(channel) + " only";
  return text;
}

void drawWipe(ViewerContext& studio, const ViewWindow& window, ImVec2 origin, ImVec2 size) {
  const ViewPictures& pictures = studio.set()->pictures();
  const WipeHandles handles =
      wipeHandles(wipeIn(studio.view.compare, pictures.width(), pictures.height()), window, origin);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(origin, ImVec2(origin.x + size.x, origin.y + size.y), true);
  const float far =
      size.x + size.y + std::abs(handles.center.x - origin.x) + std::abs(handles.center.y - origin.y);
  const ImVec2 c = handles.center, d = handles.along;
  const ImVec2 from(c.x - far * d.x, c.y - far * d.y), to(c.x + far * d.x, c.y + far * d.y);
  draw->AddLine(from, to, IM_COL32(0, 0, 0, 150), px(3));
  draw->AddLine(from, to, kLine, std::max(1.0F, px(1)));
  draw->AddCircleFilled(c, px(6), kLine);
  draw->AddCircleFilled(handles.turn, px(6), kAccent);
  draw->AddCircle(handles.turn, px(6), kLine, 0, px(1.5F));
  draw->PopClipRect();
  markRect("viewer.wipe", c.x - px(6), c.y - px(6), c.x + px(6), c.y + px(6));
  markRect("viewer.wipe.turn", handles.turn.x - px(6), handles.turn.y - px(6), handles.turn.x + px(6),
           handles.turn.y + px(6));
}

void drawSides(ViewerContext& studio, ImVec2 origin, ImVec2 size) {
  using Mode = CompareState::Mode;
  const Mode mode = studio.view.compare.mode;
  const std::string a = "A  " + subjectWords(studio, studio.view.subject);
  const std::string b = "B  " + sideBWords(studio);
  const float bottom = origin.y + size.y - ImGui::GetTextLineHeight() - px(8) - px(kMargin);
  const float left = origin.x + px(kMargin);
  if (mode == Mode::OnlyB) {
    label(b, ImVec2(left, bottom), kAccent);
  } else if (mode == Mode::Difference) {
    label("| A \u2212 B |   " + a + "   " + b, ImVec2(left, bottom), kText);
  } else if (mode == Mode::Wipe || mode == Mode::Split) {
    label(a, ImVec2(left, bottom), kText);
    const float x = mode == Mode::Split
                        ? origin.x + std::floor(size.x / 2) + px(kMargin)
                        : origin.x + size.x - ImGui::CalcTextSize(b.c_str()).x - px(16 + kMargin);
    label(b, ImVec2(x, bottom), kText);
  }
}

struct LegendLine {
  Rgb color;
  std::string words;
};

/// From the top of what it stands for to the bottom, at the viewer's right edge.
void drawLegend(const std::string& title, const std::vector<LegendLine>& lines, ImVec2 origin, ImVec2 size) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  ImGui::PushFont(fonts().small);
  const float row = ImGui::GetTextLineHeight() + px(3);
  float width = ImGui::CalcTextSize(title.c_str()).x;
  for (const LegendLine& line : lines)
    width = std::max(width, ImGui::CalcTextSize(line.words.c_str()).x + px(22));
  const ImVec2 high(origin.x + size.x - px(kMargin),
                    origin.y + px(kMargin) + row * static_cast<float>(lines.size() + 1) + px(12));
  const ImVec2 low(high.x - width - px(16), origin.y + px(kMargin));
  draw->AddRectFilled(low, high, IM_COL32(0, 0, 0, 200), px(5));
  float y = low.y + px(6);
  draw->AddText(ImVec2(low.x + px(8), y), kText, title.c_str());
  for (const LegendLine& line : lines) {
    y += row;
    draw->AddRectFilled(ImVec2(low.x + px(8), y + px(1)), ImVec2(low.x + px(22), y + row - px(2)),
                        colorU32(line.color));
    draw->AddText(ImVec2(low.x + px(30), y), kText, line.words.c_str());
  }
  ImGui::PopFont();
  markRect("viewer.legend", low.x, low.y, high.x, high.y);
}

std::vector<LegendLine> mapLegend(float brightest, const char* format, float times) {
  constexpr int kSteps = 6;
  std::vector<LegendLine> lines;
  for (int i = kSteps; i >= 0; --i) {
    const float at = static_cast<float>(i) / kSteps;
    lines.push_back({viridis(at), fmt::format(fmt::runtime(format), times * at * brightest)});
  }
  lines.front().words += " and more";
  return lines;
}

void drawLegends(ViewerContext& studio, ImVec2 origin, ImVec2 size) {
  std::vector<LegendLine> lines;
  switch (studio.view.subject.kind) {
    case ViewSubject::Kind::Residual:
      return drawLegend("Residual, in units of the noise", mapLegend(kResidualShown, "{:.1f}", 1), origin,
                        size);
    case ViewSubject::Kind::Sigma:
      return drawLegend("Standard error", mapLegend(kSigmaShown, "{:.0f} %", 100), origin, size);
    case ViewSubject::Kind::Flags:
      for (const FlagColor& flag : kFlagColors) lines.push_back({flag.color, flag.label});
      return drawLegend("Flags", lines, origin, size);
    default:
      break;
  }
  if (!studio.view.settings.falseColor) return;
  const auto bands = falseColorBands();
  for (auto band = bands.rbegin(); band != bands.rend(); ++band) lines.push_back({band->color, band->label});
  drawLegend("Stops from middle grey", lines, origin, size);
}

void drawRegion(ViewerContext& studio, const ViewWindow& window, ImVec2 origin) {
  if (!studio.viewer.region) return;
  const PictureRegion& region = *studio.viewer.region;
  const ImVec2 low = onScreen(window, origin, region.x, region.y);
  const ImVec2 high = onScreen(window, origin, region.x + region.width, region.y + region.height);
  ImGui::GetWindowDrawList()->AddRect(low, high, IM_COL32(0, 0, 0, 200), 0, 0, px(3));
  ImGui::GetWindowDrawList()->AddRect(low, high, kSolo, 0, 0, std::max(1.0F, px(1)));
}

}  // namespace

void drawViewerOverlay(ViewerContext& studio, const ViewWindow& window, ImVec2 origin, ImVec2 size) {
  drawShadowOverlay(studio, window, origin, size);
  drawPoolOverlay(studio, window, origin);
  drawRegion(studio, window, origin);
  if (studio.view.compare.mode == CompareState::Mode::Wipe) drawWipe(studio, window, origin, size);
  drawSides(studio, origin, size);
  const std::string badge = badgeText(studio.view.settings);
  if (!badge.empty()) {
    const ImVec2 at(origin.x + px(kMargin), origin.y + px(kMargin));
    const ImVec2 words = label(badge, at, kChanged, true);
    markRect("viewer.badge", at.x, at.y, at.x + words.x, at.y + words.y);
  }
  drawLegends(studio, origin, size);
  ImGui::GetWindowDrawList()->PushClipRect(origin, ImVec2(origin.x + size.x, origin.y + size.y), true);
  for (const PictureTool* tool : pictureTools())
    if (tool->overlay) tool->overlay(studio, window, origin);
  ImGui::GetWindowDrawList()->PopClipRect();
}

}  // namespace swaplight
