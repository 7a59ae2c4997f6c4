#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/edit/mask/mask.h"

namespace swaplight {

/// What a stencil or a gradient is made of, before it has a place.
struct Stencil {
  std::string shape = "text";  ///< the shape's name in files
  std::string text = "LIGHT";  ///< for shapes with a text
  std::string file;            ///< for shapes from a file
  float feather = 4;           ///< pixels; for shapes with a soft edge
  PatternShape::Kind pattern = PatternShape::Kind::Stripes;
  bool operator==(const Stencil&) const = default;
};

/// A shape that can be a stencil, and which of a stencil's values it has.
struct StencilKind {
  ShapeInfo info;
  StencilInfo stencil;
  bool text, file, feather, pattern;
};
/// All of them.
[[nodiscard]] const std::vector<StencilKind>& stencilKinds();
/// The one of this stencil.
[[nodiscard]] const StencilKind& kindOf(const Stencil& stencil);

/// The shape that a drag from one point of the picture to another draws: text stands on the lower end of the
/// drag and is as wide as it; ellipses, rectangles and gobos fill its box; a pattern's repeat is as long as
/// it, in its direction; gradients run along it. `even`: as wide as high, directions in steps of 45 degrees.
[[nodiscard]] MaskShape draggedShape(const Stencil& stencil, Point from, Point to, bool even);

/// The box around a shape that has one: text, ellipse, rectangle, gobo, radial gradient. Nothing for the
/// others, and for gobos of their own size.
[[nodiscard]] std::optional<ShapeBox> boxOf(const MaskShape& shape);
/// The shape elsewhere.
[[nodiscard]] MaskShape movedShape(const MaskShape& shape, float dx, float dy);
/// Whether a shape is one that this stencil draws.
[[nodiscard]] bool isOfKind(const MaskShape& shape, const Stencil& stencil);
/// The shape where it is, with the stencil's text, file, pattern and feather.
[[nodiscard]] MaskShape withStencil(const MaskShape& shape, const Stencil& stencil);

}  // namespace swaplight
