#pragma once

#include <array>
#include <vector>

#include "core/edit/mask/mask.h"

namespace swaplight {

/// A place by which a shape is taken hold of.
struct ShapeHandle {
  enum class What {
    Middle,  ///< moves the shape
    From,
    To,  ///< the ends of a linear gradient
    Inner,
    Outer,  ///< the radii of a radial gradient
    TopLeft,
    TopRight,
    BottomLeft,
    BottomRight,  ///< the corners of a box: the opposite one stays
  };
  What what = What::Middle;
  std::array<float, 2> at{};  ///< pixels of the picture
};

/// "middle", "from", "to", "inner", "outer", "top_left" …
[[nodiscard]] const char* handleName(ShapeHandle::What what);

/// The handles of a shape that was placed: rectangle, ellipse, text, picture, linear and radial gradient.
/// None for the others. The one that is to be taken where several lie upon each other comes first.
[[nodiscard]] std::vector<ShapeHandle> handlesOf(const MaskShape& shape);

/// The shape with one of its handles at a point of the picture. Words keep their proportions, so do boxes
/// where `even`; `even` lays the ends of a linear gradient at steps of 45 degrees. Nothing becomes smaller
/// than two pixels. A shape that lacks the handle stays as it is.
[[nodiscard]] MaskShape withHandleAt(const MaskShape& shape, ShapeHandle::What handle,
                                     std::array<float, 2> to, bool even);

}  // namespace swaplight
