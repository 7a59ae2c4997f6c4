#pragma once

#include "core/edit/fields/field.h"
#include "core/edit/raster/mask_raster.h"
#include "core/edit/shapes/shape_info.h"

namespace swaplight {

/// The inside of a closed line (even-odd).
struct PolygonShape {
  PointList points;
  float feather = 0;
  bool operator==(const PolygonShape&) const = default;

  static constexpr ShapeInfo info{"polygon", "lasso"};
  static constexpr auto fields() {
    return std::tuple{numberField("feather", &PolygonShape::feather, {}),
                      plainField("points", &PolygonShape::points)};
  }
  [[nodiscard]] MaskRaster draw(int width, int height) const;
  /// How far the points lie off the straight line from the first to the one farthest from it, on both sides
  /// together, pixels: a line that goes there and back encloses nothing. 0 without points.
  [[nodiscard]] float breadth() const;
};

}  // namespace swaplight
