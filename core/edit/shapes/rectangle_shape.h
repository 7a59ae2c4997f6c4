#pragma once

#include <optional>

#include "core/edit/fields/field.h"
#include "core/edit/raster/soft_edge.h"
#include "core/edit/shapes/shape_box.h"
#include "core/edit/shapes/shape_info.h"

namespace swaplight {

struct RectangleShape {
  float x = 0, y = 0, width = 100, height = 100, feather = 0;
  bool operator==(const RectangleShape&) const = default;

  static constexpr ShapeInfo info{"rectangle", "rectangle"};
  static constexpr StencilInfo stencil{"Rectangle", "Drag from corner to corner. Shift: a square."};
  static constexpr auto fields() {
    return std::tuple{numberField("x", &RectangleShape::x, {}), numberField("y", &RectangleShape::y, {}),
                      numberField("width", &RectangleShape::width, {}),
                      numberField("height", &RectangleShape::height, {}),
                      numberField("feather", &RectangleShape::feather, {})};
  }

  [[nodiscard]] float valueAt(float atX, float atY) const {
    const float dx = std::max(x - atX, atX - (x + width));
    const float dy = std::max(y - atY, atY - (y + height));
    const float outside = lengthOf(std::max(dx, 0.f), std::max(dy, 0.f));
    return coverage(outside + std::min(std::max(dx, dy), 0.f), feather);
  }
  [[nodiscard]] PixelRect bounds() const { return pixelsAround(x, y, x + width, y + height, feather); }

  [[nodiscard]] std::optional<ShapeBox> box() const { return ShapeBox{x, y, x + width, y + height}; }
  void fit(const ShapeBox& box) { x = box.x0, y = box.y0, width = box.x1 - box.x0, height = box.y1 - box.y0; }
  void place(const StencilDrag& drag) { x = drag.x, y = drag.y, width = drag.width, height = drag.height; }
};

}  // namespace swaplight
