#include "ui/viewer_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/relight/rig.h"
#include "ui/layout_probe.h"
#include "ui/pick_tool.h"
#include "ui/theme.h"

namespace swaplight {
namespace {

constexpr double kWheelStep = 1.15;  // zoom a notch of the wheel

/// The part of the viewer that the picture covers, in whole pixels of the viewer.
struct Covered {
  int x = 0, y = 0;
  ViewWindow window;
};

Covered coveredPart(const ViewWindow& window, int pictureWidth, int pictureHeight) {
  const auto clampX = [&](double v) { return std::clamp(static_cast<int>(std::lround(v)), 0, window.width); };
  const auto clampY = [&](double v) {
    return std::clamp(static_cast<int>(std::lround(v)), 0, window.height);
  };
  const int left = clampX(window.windowX(0));
  const int right = clampX(window.windowX(pictureWidth));
  const int top = clampY(window.windowY(0));
  const int bottom = clampY(window.windowY(pictureHeight));
  Covered covered{left, top, window};
  covered.window.left = std::max(0.0, window.pictureX(left));
  covered.window.top = std::max(0.0, window.pictureY(top));
  covered.window.width = right - left;
  covered.window.height = bottom - top;
  return covered;
}

void handleMouse(StudioContext& studio, const ViewWindow& window, ImVec2 origin) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    studio.view.zoomAt(window, io.MousePos.x - origin.x, io.MousePos.y - origin.y,
                       std::pow(kWheelStep, io.MouseWheel));
  }
  const Tool tool = io.KeyAlt ? Tool::Match : studio.tool;
  if (tool != Tool::Look) {
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsItemClicked(ImGuiMouseButton_Left)) {
      const auto x = static_cast<int>(std::floor(window.pictureX(io.MousePos.x - origin.x)));
      const auto y = static_cast<int>(std::floor(window.pictureY(io.MousePos.y - origin.y)));
      const ViewPictures& pictures = *studio.set()->pictures;
      if (x >= 0 && y >= 0 && x < pictures.width() && y < pictures.height()) pickPixel(studio, tool, x, y);
    }
    return;
  }
  const bool panButton =
      ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0) || ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0);
  if (ImGui::IsItemActive() && panButton && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0))
    studio.view.pan(window, io.MouseDelta.x, io.MouseDelta.y);
}

std::string badgeText(const ViewState& view) {
  std::string text;
  const ViewSettings& settings = view.settings;
  if (settings.exposureStops != 0) text += fmt::format("viewer {:+.2f} st", settings.exposureStops);
  if (settings.gamma != 1)
    text += fmt::format("{}gamma {:.2f}", text.empty() ? "viewer " : "  ", settings.gamma);
  return text;
}

void drawBadge(const std::string& text, ImVec2 at) {
  if (text.empty()) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 high(at.x + size.x + px(16), at.y + size.y + px(8));
  draw->AddRectFilled(at, high, IM_COL32(0, 0, 0, 170), px(5));
  draw->AddRect(at, high, kChanged, px(5));
  draw->AddText(ImVec2(at.x + px(8), at.y + px(4)), kChanged, text.c_str());
}

}  // namespace

void drawViewerPanel(StudioContext& studio) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  if (size.x < 1 || size.y < 1) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(origin, ImVec2(origin.x + size.x, origin.y + size.y), kViewerGround);
  markRect("viewer", origin.x, origin.y, origin.x + size.x, origin.y + size.y);
  studio.shown.valid = false;
  const OpenSet* set = studio.set();
  if (!set) return;

  const ViewPictures& pictures = *set->pictures;
  ViewWindow window = studio.view.window(pictures.width(), pictures.height(), static_cast<int>(size.x),
                                         static_cast<int>(size.y));
  ImGui::InvisibleButton("##picture", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  handleMouse(studio, window, origin);
  window = studio.view.window(pictures.width(), pictures.height(), window.width, window.height);

  const Covered covered = coveredPart(window, pictures.width(), pictures.height());
  if (covered.window.width < 1 || covered.window.height < 1) return;
  const Document& document = studio.document();
  ScreenRequest request;
  request.a.layers = pictures.layers(studio.view.subject, rigFactors(document.rig, set->solved->colorSpace()),
                                     document.rig.ambient);
  request.a.colorSpace = set->solved->colorSpace();
  request.window = covered.window;
  request.settings = studio.view.settings;
  request.settings.display = document.display.display;
  request.settings.view = document.display.view;
  const unsigned texture = studio.pictures.texture(request);
  const ImVec2 low(origin.x + static_cast<float>(covered.x), origin.y + static_cast<float>(covered.y));
  const ImVec2 high(low.x + static_cast<float>(covered.window.width),
                    low.y + static_cast<float>(covered.window.height));
  draw->AddImage(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(texture)), low, high);  // NOLINT
  markRect("viewer.picture", low.x, low.y, high.x, high.y);
  studio.shown = {true, window, origin.x, origin.y};
  drawBadge(badgeText(studio.view), ImVec2(origin.x + px(12), origin.y + px(12)));
}

}  // namespace swaplight
