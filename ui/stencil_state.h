#pragma once

#include <optional>

#include "core/edit/drag_shape.h"
#include "core/session/document.h"

namespace swaplight {

/// The stencil or gradient through which light is laid on, and the drag that is under way.
struct StencilState {
  ShapeKind kind;
  bool invert = false;

  struct Going {
    Document before;
    size_t edit = 0;  ///< its place in the list
    Edit base;        ///< with the shape that is moved, or without one
    bool moves = false;
    std::array<float, 2> from{};
  };
  std::optional<Going> going;
};

}  // namespace swaplight
