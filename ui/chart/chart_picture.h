#pragma once

#include <imgui.h>

#include <optional>

#include "core/chart/chart_corners.h"
#include "core/chart/chart_fit.h"
#include "core/image/small_picture.h"
#include "render/surface.h"

namespace swaplight {

/// The photograph with the chart's patches drawn over it, and its four corners to be dragged.
class ChartPicture {
 public:
  /// Another photograph, shown as `small`; `width` and `height` are its own, in whose pixels corners are.
  void show(const SmallPicture& small, int width, int height);

  /// Draws it in a rectangle of the screen, as large as it fits. `fit`: what each patch was read as; null:
  /// the corners are not of a chart. True in the frame in which a corner was let go elsewhere.
  bool draw(ImVec2 low, ImVec2 size, ChartCorners& corners, const ChartFit* fit);

  /// A corner is held and has moved.
  [[nodiscard]] bool isDragged() const { return m_moved; }

 private:
  [[nodiscard]] ImVec2 onScreen(const PicturePlace& place) const;
  void drawPatches(const ChartCorners& corners, const ChartFit* fit) const;
  bool dragCorners(ChartCorners& corners);

  SurfaceTexture m_texture;
  int m_smallWidth = 0, m_smallHeight = 0;
  int m_width = 1, m_height = 1;
  ImVec2 m_low{};     ///< where the picture lies
  float m_scale = 1;  ///< pixels of the screen for one of the photograph
  bool m_moved = false;
};

}  // namespace swaplight
