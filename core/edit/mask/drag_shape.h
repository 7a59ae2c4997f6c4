#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/edit/mask/mask.h"

namespace swaplight {

/// What a stencil or a gradient is made of, before it has a place.
struct ShapeKind {
  enum class Kind { Text, Ellipse, Rectangle, Pattern, Picture, Linear, Radial };
  Kind kind = Kind::Text;
  std::string text = "LIGHT";  ///< for Text
  std::string file;            ///< for Picture
  float feather = 4;           ///< pixels; not for pictures and gradients
  PatternShape::Kind pattern = PatternShape::Kind::Stripes;
  bool operator==(const ShapeKind&) const = default;
};

/// The shape that a drag from one point of the picture to another draws: text stands on the lower end of the
/// drag and is as wide as it; ellipses, rectangles and pictures fill its box; a pattern's repeat is as long
/// as it, in its direction; gradients run along it. `even`: as wide as high, directions in steps of 45
/// degrees.
[[nodiscard]] MaskShape draggedShape(const ShapeKind& kind, std::array<float, 2> from,
                                     std::array<float, 2> to, bool even);

/// The point as far away in the next direction that is a multiple of 45 degrees.
[[nodiscard]] std::array<float, 2> evenDirection(std::array<float, 2> from, std::array<float, 2> to);

/// A box in pixels of the picture.
struct ShapeBox {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  [[nodiscard]] bool contains(std::array<float, 2> at) const {
    return at[0] >= x0 && at[0] < x1 && at[1] >= y0 && at[1] < y1;
  }
};
/// The box around a shape that has one: text, ellipse, rectangle, picture, radial gradient. Nothing for the
/// others, and for pictures of their own size.
[[nodiscard]] std::optional<ShapeBox> boxOf(const MaskShape& shape);
/// The shape elsewhere.
[[nodiscard]] MaskShape movedShape(const MaskShape& shape, float dx, float dy);
/// Whether a shape is one that this kind draws.
[[nodiscard]] bool isOfKind(const MaskShape& shape, ShapeKind::Kind kind);
/// The shape where it is, with the kind's words, file and feather.
[[nodiscard]] MaskShape withKind(const MaskShape& shape, const ShapeKind& kind);

}  // namespace swaplight
