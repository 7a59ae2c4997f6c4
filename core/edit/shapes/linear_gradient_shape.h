#pragma once

#include "core/edit/fields/field.h"
#include "core/edit/raster/soft_edge.h"
#include "core/edit/shapes/shape_box.h"
#include "core/edit/shapes/shape_info.h"

namespace swaplight {

/// 1 before the first point, 0 behind the second, smooth between.
struct LinearGradientShape {
  float x0 = 0, y0 = 0, x1 = 100, y1 = 0;
  bool operator==(const LinearGradientShape&) const = default;

  static constexpr ShapeInfo info{"linear", "gradient"};
  static constexpr StencilInfo stencil{"Gradient",
                                       "Drag from full effect to none. Shift: in steps of 45 degrees."};
  static constexpr auto fields() {
    return std::tuple{
        numberField("x0", &LinearGradientShape::x0, {}), numberField("y0", &LinearGradientShape::y0, {}),
        numberField("x1", &LinearGradientShape::x1, {}), numberField("y1", &LinearGradientShape::y1, {})};
  }

  [[nodiscard]] float valueAt(float x, float y) const {
    const float dx = x1 - x0;
    const float dy = y1 - y0;
    const float length2 = dx * dx + dy * dy;
    return length2 > 0 ? smoothStep(1 - ((x - x0) * dx + (y - y0) * dy) / length2) : 1;
  }

  [[nodiscard]] std::vector<ShapeHandle> handles() const {
    using What = ShapeHandle::What;
    return {{What::To, {x1, y1}}, {What::From, {x0, y0}}, {What::Middle, {(x0 + x1) / 2, (y0 + y1) / 2}}};
  }
  void setHandle(ShapeHandle::What end, Point to, bool even) {
    if (end == ShapeHandle::What::From) {
      if (even) to = evenDirection({x1, y1}, to);
      x0 = to[0], y0 = to[1];
    } else if (end == ShapeHandle::What::To) {
      if (even) to = evenDirection({x0, y0}, to);
      x1 = to[0], y1 = to[1];
    }
  }
  static constexpr bool kDragsDirection = true;
  void place(const StencilDrag& drag) {
    x0 = drag.from[0], y0 = drag.from[1], x1 = drag.to[0], y1 = drag.to[1];
  }
};

}  // namespace swaplight
