#pragma once

#include <optional>

#include "core/edit/fields/field.h"
#include "core/edit/raster/soft_edge.h"
#include "core/edit/shapes/shape_box.h"
#include "core/edit/shapes/shape_info.h"

namespace swaplight {

struct EllipseShape {
  float x = 0, y = 0, radiusX = 50, radiusY = 50, feather = 0;  ///< x and y: the centre
  bool operator==(const EllipseShape&) const = default;

  static constexpr ShapeInfo info{"ellipse", "ellipse"};
  static constexpr StencilInfo stencil{"Ellipse", "Drag from corner to corner. Shift: a circle."};
  static constexpr auto fields() {
    return std::tuple{numberField("x", &EllipseShape::x, {}), numberField("y", &EllipseShape::y, {}),
                      numberField("radius_x", &EllipseShape::radiusX, {}),
                      numberField("radius_y", &EllipseShape::radiusY, {}),
                      numberField("feather", &EllipseShape::feather, {})};
  }

  /// The distance is exact for circles, and good near the rim of ellipses.
  [[nodiscard]] float valueAt(float atX, float atY) const {
    const float u = (atX - x) / radiusX;
    const float v = (atY - y) / radiusY;
    const float r = lengthOf(u, v);
    const float slope = lengthOf(u / radiusX, v / radiusY);
    const float distance = slope > 0 ? r * (r - 1) / slope : -std::min(radiusX, radiusY);
    return coverage(distance, feather);
  }
  /// A soft thin ellipse reaches far: be generous.
  [[nodiscard]] PixelRect bounds() const {
    return pixelsAround(x - radiusX, y - radiusY, x + radiusX, y + radiusY,
                        feather * std::max(radiusX, radiusY) / std::max(std::min(radiusX, radiusY), 1.f));
  }

  [[nodiscard]] std::optional<ShapeBox> box() const {
    return ShapeBox{x - radiusX, y - radiusY, x + radiusX, y + radiusY};
  }
  void fit(const ShapeBox& box) {
    const Point middle = box.middle();
    x = middle[0], y = middle[1], radiusX = (box.x1 - box.x0) / 2, radiusY = (box.y1 - box.y0) / 2;
  }
  void place(const StencilDrag& drag) {
    x = drag.x + drag.width / 2, y = drag.y + drag.height / 2;
    radiusX = drag.width / 2, radiusY = drag.height / 2;
  }
};

}  // namespace swaplight
