#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/edit/mask/selection_shape.h"
#include "core/edit/shapes/ellipse_shape.h"
#include "core/edit/shapes/image_shape.h"
#include "core/edit/shapes/key_shape.h"
#include "core/edit/shapes/linear_gradient_shape.h"
#include "core/edit/shapes/paint_shape.h"
#include "core/edit/shapes/pattern_shape.h"
#include "core/edit/shapes/polygon_shape.h"
#include "core/edit/shapes/radial_gradient_shape.h"
#include "core/edit/shapes/rectangle_shape.h"
#include "core/edit/shapes/shadow_shape.h"
#include "core/edit/shapes/similar_shape.h"
#include "core/edit/shapes/text_shape.h"

namespace swaplight {

// Where an edit acts, 0..1. All lengths are pixels of the picture; feather is the width over which an edge
// falls from 1 to 0, half of it on either side. A shape is a value struct in a file of its own, with
//
//   static constexpr ShapeInfo info            its names
//   static constexpr auto fields()             its values in files
//   float valueAt(float x, float y) const      a formula, with PixelRect bounds() const where it ends; or
//   MaskRaster draw(int width, int height) const   pixels, drawn once
//
// (shadows, what is similar, keys and selections need the set to be drawn: MaskContext::raster)
//
// and, where it needs them,
//
//   void writeMore(Json&) const, void readMore(JsonFields&, int width, int height)   what fields() cannot say
//   void check(const std::string& where) const   throws InputError
//   std::optional<ShapeBox> box() const, void fit(const ShapeBox&)   the box by whose corners it is dragged
//   std::vector<ShapeHandle> handles() const, void setHandle(what, to, even)   other handles than a box's
//   static constexpr StencilInfo stencil, void place(const StencilDrag&)   a stencil that a drag places
//   static constexpr bool kDragsDirection = true   Shift holds the drag's direction, not its proportions
//
// and it is listed here.

struct MaskShape {
  std::variant<RectangleShape, EllipseShape, PolygonShape, LinearGradientShape, RadialGradientShape,
               PatternShape, TextShape, ImageShape, PaintShape, ShadowShape, SimilarShape, KeyShape,
               SelectionShape>
      shape;
  bool invert = false;
  bool operator==(const MaskShape&) const = default;
};

using AnyShape = decltype(MaskShape::shape);

/// Calls visit(T{}) for each kind of shape, in the list's order.
template <typename Visit>
void forEachShape(const Visit& visit) {
  [&]<typename... T>(std::type_identity<std::variant<T...>>) {
    (visit(T{}), ...);
  }(std::type_identity<AnyShape>{});
}

struct SelectionPart {
  enum class Combine { Add, Subtract, Intersect };
  MaskShape shape;
  Combine how = Combine::Add;
  bool operator==(const SelectionPart&) const = default;
};

/// Shapes multiplied with each other: each restricts the others. Without a shape: everywhere.
using Mask = std::vector<MaskShape>;

[[nodiscard]] Json jsonFromMask(const Mask& mask);
/// Paintings are replayed in the size given. `warnings`: gets a sentence for each key that is not used.
/// Throws InputError.
[[nodiscard]] Mask maskFromJson(const Json& json, int width, int height, const std::string& where,
                                std::vector<std::string>* warnings = nullptr);

}  // namespace swaplight
