#pragma once

#include <optional>

#include "core/edit/mask/drag_shape.h"
#include "core/session/document.h"

namespace swaplight {

/// The stencil or gradient through which light is laid on, and the drag that is under way.
struct StencilState {
  Stencil stencil;
  bool invert = false;

  struct Going {
    Document before;
    Edit base;  ///< without a shape
    std::array<float, 2> from{};
  };
  std::optional<Going> going;
};

}  // namespace swaplight
