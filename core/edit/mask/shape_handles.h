#pragma once

#include <vector>

#include "core/edit/mask/mask.h"

namespace swaplight {

/// "middle", "from", "to", "inner", "outer", "top_left" …
[[nodiscard]] const char* handleName(ShapeHandle::What what);

/// The handles of a shape that was placed: rectangle, ellipse, text, gobo, linear and radial gradient. None
/// for the others. The one that is to be taken where several lie upon each other comes first.
[[nodiscard]] std::vector<ShapeHandle> handlesOf(const MaskShape& shape);

/// The shape with one of its handles at a point of the picture. Text keeps its proportions, so do boxes
/// where `even`; `even` lays the ends of a linear gradient at steps of 45 degrees. Nothing becomes smaller
/// than two pixels. A shape that lacks the handle stays as it is.
[[nodiscard]] MaskShape withHandleAt(const MaskShape& shape, ShapeHandle::What handle, Point to, bool even);

}  // namespace swaplight
