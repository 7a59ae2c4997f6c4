#include "ui/viewer/viewer_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/surface.h"
#include "ui/camera/camera_look_edit.h"
#include "ui/control/viewer_request.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/viewer/viewer_bar.h"
#include "ui/viewer/viewer_mouse.h"
#include "ui/viewer/viewer_overlay.h"
#include "ui/viewer/which_light.h"

namespace swaplight {
namespace {

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

/// The viewer's ground beside a picture, not under it: filling the screen twice is slow in software.
void drawGroundAround(ImVec2 low, ImVec2 high, ImVec2 from, ImVec2 to) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto fill = [&](ImVec2 a, ImVec2 b) {
    if (a.x < b.x && a.y < b.y) draw->AddRectFilled(a, b, kViewerGround);
  };
  fill(from, ImVec2(to.x, low.y));
  fill(ImVec2(from.x, high.y), to);
  fill(ImVec2(from.x, low.y), ImVec2(low.x, high.y));
  fill(ImVec2(high.x, low.y), ImVec2(to.x, high.y));
}

/// Copies a texture to the screen when Dear ImGui comes to this place of its list. Until then what to copy is
/// kept here, by the texture's place.
void copyWhenDrawn(const SurfaceCopy& copy, int place) {
  static std::array<SurfaceCopy, 2> copies;
  SurfaceCopy& kept = copies.at(static_cast<size_t>(place));
  kept = copy;
  ImGui::GetWindowDrawList()->AddCallback(
      [](const ImDrawList*, const ImDrawCmd* command) {
        copyToSurface(*static_cast<const SurfaceCopy*>(command->UserCallbackData));
      },
      &kept);
}

/// Draws pictures into a pane whose corner is `origin`. The texture is told apart by `place`.
void drawPane(ViewerContext& studio, const LayeredPicture& a, const LayeredPicture* b,
              const ViewWindow& window, ImVec2 origin, int place) {
  const ViewPictures& pictures = studio.set()->pictures();
  const Covered covered = coveredPart(window, pictures.width(), pictures.height());
  if (covered.window.width < 1 || covered.window.height < 1) return;
  ViewportRequest request;
  request.a = a;
  if (b) {
    request.b = *b;
    request.comparison = wipeIn(studio.view.compare, pictures.width(), pictures.height());
    if (studio.view.compare.mode == CompareState::Mode::Difference)
      request.comparison = {Comparison::Mode::Difference};
  }
  request.window = covered.window;
  request.settings = viewerSettings(studio);
  const unsigned texture = studio.renderer.texture(request, place);
  const ImVec2 low(origin.x + static_cast<float>(covered.x), origin.y + static_cast<float>(covered.y));
  const ImVec2 high(low.x + static_cast<float>(covered.window.width),
                    low.y + static_cast<float>(covered.window.height));
  const ImVec2 to(origin.x + static_cast<float>(window.width), origin.y + static_cast<float>(window.height));
  drawGroundAround(low, high, origin, to);
  copyWhenDrawn({texture, covered.window.width, covered.window.height, static_cast<int>(low.x),
                 static_cast<int>(low.y), static_cast<int>(ImGui::GetIO().DisplaySize.y)},
                place);
  markRect(place == 0 ? "viewer.picture" : "viewer.picture_b", low.x, low.y, high.x, high.y);
}

void drawPanes(ViewerContext& studio, const ViewWindow& window, ImVec2 origin) {
  using Mode = CompareState::Mode;
  const ViewerPictures pictures = viewerPictures(studio);
  const Mode mode = studio.view.compare.mode;
  const LayeredPicture* a = pictures.a ? &*pictures.a : nullptr;
  const LayeredPicture* b = pictures.b ? &*pictures.b : nullptr;
  const bool overlaid = mode == Mode::Wipe || mode == Mode::Difference;
  if (mode == Mode::OnlyB) a = b;
  const auto empty = [&](ImVec2 at) {
    drawGroundAround(
        at, at, at,
        ImVec2(at.x + static_cast<float>(window.width), at.y + static_cast<float>(window.height)));
  };
  if (!a) empty(origin);
  if (a) drawPane(studio, *a, overlaid ? b : nullptr, window, origin, 0);
  if (mode == Mode::Split && b)
    drawPane(studio, *b, nullptr, window, ImVec2(origin.x + static_cast<float>(window.width), origin.y), 1);
}

/// A filter of the library that is dropped on the picture goes behind all others.
void dropFilterHere(ViewerContext& studio) {
  if (!ImGui::BeginDragDropTarget()) return;
  if (const ImGuiPayload* filter = ImGui::AcceptDragDropPayload(kDraggedFilter))
    studio.cameraLook.chosen =
        static_cast<int>(addFilter(studio.editor, static_cast<const char*>(filter->Data)));
  ImGui::EndDragDropTarget();
}

}  // namespace

void drawViewerPanel(ViewerContext& studio) {
  if (studio.set()) drawViewerBar(studio);
  studio.drawn = {};
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  if (size.x < 1 || size.y < 1) return;
  markRect("viewer", origin.x, origin.y, origin.x + size.x, origin.y + size.y);
  const OpenSet* set = studio.set();
  if (!set) {
    ImGui::GetWindowDrawList()->AddRectFilled(origin, ImVec2(origin.x + size.x, origin.y + size.y),
                                              kViewerGround);
    return;
  }

  const ViewPictures& pictures = set->pictures();
  const bool split = studio.view.compare.mode == CompareState::Mode::Split;
  const int paneWidth = static_cast<int>(size.x) / (split ? 2 : 1);
  const auto seen = [&] {
    return studio.view.window(pictures.width(), pictures.height(), paneWidth, static_cast<int>(size.y));
  };
  ImGui::InvisibleButton("##picture", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  dropFilterHere(studio);
  studio.viewer.plain = studio.keyboard.isHeld("V") && !ImGui::GetIO().WantTextInput;
  const bool overB = split && ImGui::GetIO().MousePos.x >= origin.x + static_cast<float>(paneWidth);
  const ImVec2 under(origin.x + (overB ? static_cast<float>(paneWidth) : 0), origin.y);
  handleViewerMouse(studio, seen(), under);
  const ViewWindow window = seen();
  studio.drawn = {true, window, under.x, under.y, ImGui::IsItemHovered(), studio.editor.revision()};
  markState("viewer.window", fmt::format("{} {} {}", window.left, window.top, window.zoom));
  studio.edits.show(visiblePart(window));
  drawPanes(studio, window, origin);
  drawViewerOverlay(studio, window, origin, size);
  drawProbeCard(studio, origin, size);
  drawWhichLight(studio, origin, size);
}

}  // namespace swaplight
