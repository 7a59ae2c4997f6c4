#pragma once

#include <optional>
#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/raster/mask_raster.h"
#include "core/edit/shapes/shape_box.h"
#include "core/edit/shapes/shape_info.h"

namespace swaplight {

struct TextShape {
  std::string text;
  float x = 0, y = 0;  ///< the left end of the baseline
  float height = 100;  ///< of a line
  float feather = 0;
  bool operator==(const TextShape&) const = default;

  static constexpr ShapeInfo info{"text", "text"};
  static constexpr StencilInfo stencil{"Text", "Drag: the text becomes as wide as the drag."};
  static constexpr auto fields() {
    return std::tuple{numberField("x", &TextShape::x, {}), numberField("y", &TextShape::y, {}),
                      numberField("height", &TextShape::height, {}),
                      numberField("feather", &TextShape::feather, {}), plainField("text", &TextShape::text)};
  }
  [[nodiscard]] MaskRaster draw(int width, int height) const;

  [[nodiscard]] std::optional<ShapeBox> box() const;
  /// Another size in the same proportions. The drawn width is in whole pixels: the corner that stays is kept
  /// in place.
  void setCorner(ShapeHandle::What corner, Point to);
  /// Stands on the drag's lower end and is as wide as it.
  void place(const StencilDrag& drag);
};

}  // namespace swaplight
