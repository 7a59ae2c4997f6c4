#pragma once

#include <optional>
#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/raster/mask_raster.h"
#include "core/edit/shapes/shape_box.h"
#include "core/edit/shapes/shape_info.h"

namespace swaplight {

/// A gobo from an image: its brightness (luminance of the code values; alpha multiplied in), stretched over a
/// rectangle. 0 around it.
struct ImageShape {
  std::string file;
  float x = 0, y = 0, width = 0, height = 0;  ///< width or height 0: the image's own size
  bool operator==(const ImageShape&) const = default;

  static constexpr ShapeInfo info{"picture", "gobo"};
  static constexpr StencilInfo stencil{
      "Gobo", "Projects the light through an image: bright parts let it pass. Drag from corner to corner."};
  static constexpr auto fields() {
    return std::tuple{numberField("x", &ImageShape::x, {}), numberField("y", &ImageShape::y, {}),
                      numberField("width", &ImageShape::width, {}),
                      numberField("height", &ImageShape::height, {}), plainField("file", &ImageShape::file)};
  }
  /// Throws InputError where the file cannot be read.
  [[nodiscard]] MaskRaster draw(int pictureWidth, int pictureHeight) const;

  [[nodiscard]] std::optional<ShapeBox> box() const {
    if (!(width > 0 && height > 0)) return std::nullopt;
    return ShapeBox{x, y, x + width, y + height};
  }
  void fit(const ShapeBox& box) { x = box.x0, y = box.y0, width = box.x1 - box.x0, height = box.y1 - box.y0; }
  void place(const StencilDrag& drag) { x = drag.x, y = drag.y, width = drag.width, height = drag.height; }
};

}  // namespace swaplight
