#include "ui/viewer/viewer_mouse.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/control/shadow_edit.h"
#include "ui/control/viewer_request.h"
#include "ui/kit/over_picture.h"
#include "ui/kit/theme.h"
#include "ui/tools/picture_tool.h"
#include "ui/tools/pointer.h"
#include "ui/viewer/which_light.h"

namespace swaplight {
namespace {

using Grab = ViewerState::Grab;

constexpr double kWheelStep = 1.15;  // zoom a notch of the wheel
constexpr float kStopsPerPixel = 0.01F;
constexpr float kHandleReach = 9;  // pixels at scale 1
constexpr float kTurnDistance = 90;
constexpr float kClickReach = 4;  ///< a button that was held over more is a drag

float distance(ImVec2 a, ImVec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// What the left button takes hold of here.
Grab grabbed(const ViewerContext& studio, const ViewWindow& window, ImVec2 origin) {
  if (studio.keyboard.isHeld("E")) return Grab::Exposure;
  if (asksWhichLight(studio)) return Grab::Light;
  if (studio.tool == &kScopeRegion) return Grab::Region;
  if (studio.view.compare.mode != CompareState::Mode::Wipe) return Grab::Pan;
  const ViewPictures& pictures = studio.set()->pictures();
  const WipeHandles handles =
      wipeHandles(wipeIn(studio.view.compare, pictures.width(), pictures.height()), window, origin);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (distance(mouse, handles.turn) < px(kHandleReach + 3)) return Grab::WipeTurn;
  const ImVec2 from(mouse.x - handles.center.x, mouse.y - handles.center.y);
  const float across = std::abs(from.x * handles.along.y - from.y * handles.along.x);
  return across < px(kHandleReach) ? Grab::WipeMove : Grab::Pan;
}

void turnWipe(CompareState& compare, const ViewPictures& pictures, const ViewWindow& window, ImVec2 origin) {
  const WipeHandles handles =
      wipeHandles(wipeIn(compare, pictures.width(), pictures.height()), window, origin);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const double dx = mouse.x - handles.center.x, dy = mouse.y - handles.center.y;
  if (std::hypot(dx, dy) < px(4)) return;
  double degrees = std::atan2(-dx, dy) * 180 / std::numbers::pi;
  if (ImGui::GetIO().KeyShift) degrees = std::round(degrees / 15) * 15;
  compare.angleDegrees = degrees;
}

void drawRegion(ViewerContext& studio, const ViewWindow& window, ImVec2 origin, bool begin) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ViewPictures& pictures = studio.set()->pictures();
  const auto x = std::clamp(static_cast<int>(window.pictureX(mouse.x - origin.x)), 0, pictures.width() - 1);
  const auto y = std::clamp(static_cast<int>(window.pictureY(mouse.y - origin.y)), 0, pictures.height() - 1);
  ViewerState& viewer = studio.viewer;
  if (begin) {
    viewer.regionX = x;
    viewer.regionY = y;
  }
  viewer.region = PictureRegion{std::min(x, viewer.regionX), std::min(y, viewer.regionY),
                                std::abs(x - viewer.regionX) + 1, std::abs(y - viewer.regionY) + 1};
}

void drag(ViewerContext& studio, const ViewWindow& window, ImVec2 origin) {
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  const ViewPictures& pictures = studio.set()->pictures();
  CompareState& compare = studio.view.compare;
  switch (studio.viewer.grab) {
    case Grab::None:
    case Grab::Light:
      return;
    case Grab::Pan:
      if (delta.x != 0 || delta.y != 0) studio.view.pan(window, delta.x, delta.y);
      return;
    case Grab::Exposure:
      studio.view.settings.exposureStops =
          std::clamp(studio.view.settings.exposureStops + delta.x * kStopsPerPixel, -20.0F, 20.0F);
      return;
    case Grab::WipeMove:
      compare.x += delta.x / window.zoom / pictures.width();
      compare.y += delta.y / window.zoom / pictures.height();
      return;
    case Grab::WipeTurn:
      return turnWipe(compare, pictures, window, origin);
    case Grab::Region:
      return drawRegion(studio, window, origin, false);
  }
}

/// The tool whose the mouse is; nullptr: the viewer's own.
const PictureTool* toolAtWork(ViewerContext& studio, const ToolInput& input) {
  for (const PictureTool* tool : pictureTools())
    if (tool->wants(studio, input) && tool->handle(studio, input)) return tool;
  return nullptr;
}

void showCursor(const PictureTool* tool, Grab over) {
  if (tool) {
    if (tool->cursor != PictureTool::kOwnCursor) ImGui::SetMouseCursor(tool->cursor);
  } else if (over == Grab::WipeMove || over == Grab::WipeTurn || over == Grab::Light) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  } else if (over == Grab::Exposure) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  }
}

}  // namespace

WipeHandles wipeHandles(const Comparison& wipe, const ViewWindow& window, ImVec2 origin) {
  const double angle = wipe.angleDegrees * std::numbers::pi / 180;
  WipeHandles handles;
  handles.center = onScreen(window, origin, wipe.x, wipe.y);
  handles.along = ImVec2(static_cast<float>(-std::sin(angle)), static_cast<float>(std::cos(angle)));
  handles.turn = ImVec2(handles.center.x + px(kTurnDistance) * handles.along.x,
                        handles.center.y + px(kTurnDistance) * handles.along.y);
  return handles;
}

void handleViewerMouse(ViewerContext& studio, const ViewWindow& window, ImVec2 origin) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsItemHovered();
  const bool moves = studio.keyboard.isHeld("E") || studio.keyboard.isHeld("Space") || asksWhichLight(studio);
  Grab& grab = studio.viewer.grab;
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) grab = Grab::Pan;
  const PictureTool* tool =
      toolAtWork(studio, {window, origin, hovered, io.KeyAlt, moves, grab != Grab::None});
  if (hovered && io.MouseWheel != 0 && !(tool && tool->takesCtrlWheel && io.KeyCtrl))
    studio.view.zoomAt(window, io.MousePos.x - origin.x, io.MousePos.y - origin.y,
                       std::pow(kWheelStep, io.MouseWheel));
  if (!tool && hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    grab = grabbed(studio, window, origin);
    if (grab == Grab::Region) drawRegion(studio, window, origin, true);
    if (grab == Grab::Light) selectLightOf(studio, pixelUnder(studio, window, origin));
  }
  const bool clicked = hovered && grab == Grab::Pan && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
                       io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < px(kClickReach) * px(kClickReach);
  if (clicked && shadowsShown(studio))
    if (const auto pixel = pixelUnder(studio, window, origin)) studio.shadows.choose(pixel->x, pixel->y);
  if (!io.MouseDown[ImGuiMouseButton_Left] && !io.MouseDown[ImGuiMouseButton_Middle]) grab = Grab::None;
  drag(studio, window, origin);
  if (hovered) showCursor(tool, grab == Grab::None ? grabbed(studio, window, origin) : grab);
}

}  // namespace swaplight
