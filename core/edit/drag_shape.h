#pragma once

#include <string>

#include "core/edit/mask.h"

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

/// The box around a shape that has one, in pixels of the picture: text, ellipse, rectangle, picture, radial
/// gradient. Empty for the others.
[[nodiscard]] PixelRect boxOf(const MaskShape& shape);
/// The shape elsewhere.
[[nodiscard]] MaskShape movedShape(const MaskShape& shape, float dx, float dy);
/// Whether a shape is one that this kind draws.
[[nodiscard]] bool isOfKind(const MaskShape& shape, ShapeKind::Kind kind);
/// The shape where it is, with the kind's words, file and feather.
[[nodiscard]] MaskShape withKind(const MaskShape& shape, const ShapeKind& kind);

}  // namespace swaplight
