#pragma once

#include <optional>

#include "core/edit/fields/field.h"
#include "core/edit/raster/soft_edge.h"
#include "core/edit/shapes/shape_box.h"
#include "core/edit/shapes/shape_info.h"

namespace swaplight {

/// 1 within the inner radius, 0 outside the outer, smooth between.
struct RadialGradientShape {
  float x = 0, y = 0, inner = 0, outer = 100;
  bool operator==(const RadialGradientShape&) const = default;

  static constexpr ShapeInfo info{"radial", "radial gradient"};
  static constexpr StencilInfo stencil{"Radial", "Drag from the centre to the rim."};
  static constexpr auto fields() {
    return std::tuple{numberField("x", &RadialGradientShape::x, {}),
                      numberField("y", &RadialGradientShape::y, {}),
                      numberField("inner", &RadialGradientShape::inner, {}),
                      numberField("outer", &RadialGradientShape::outer, {})};
  }

  [[nodiscard]] float valueAt(float atX, float atY) const {
    const float r = lengthOf(atX - x, atY - y);
    return outer > inner ? smoothStep((outer - r) / (outer - inner)) : r <= inner;
  }
  [[nodiscard]] PixelRect bounds() const {
    const float r = std::max(inner, outer);
    return pixelsAround(x - r, y - r, x + r, y + r, 0);
  }

  [[nodiscard]] std::optional<ShapeBox> box() const {
    return ShapeBox{x - outer, y - outer, x + outer, y + outer};
  }
  [[nodiscard]] std::vector<ShapeHandle> handles() const {
    using What = ShapeHandle::What;
    return {{What::Outer, {x + outer, y}}, {What::Inner, {x - inner, y}}, {What::Middle, {x, y}}};
  }
  void setHandle(ShapeHandle::What which, Point to, bool /*even*/) {
    const float radius = std::hypot(to[0] - x, to[1] - y);
    if (which == ShapeHandle::What::Inner) inner = std::min(radius, outer);
    if (which != ShapeHandle::What::Outer) return;
    outer = std::max(radius, kLeastSide);
    inner = std::min(inner, outer);
  }
  void place(const StencilDrag& drag) {
    constexpr float kCore = .25F;  // of the radius
    x = drag.from[0], y = drag.from[1], inner = kCore * drag.length,
    outer = std::max(drag.length, kLeastSide);
  }
};

}  // namespace swaplight
