#pragma once

#include <optional>

#include "core/edit/mask/shape_handles.h"
#include "core/session/document.h"

namespace swaplight {

/// The handle of a placed stencil or gradient that is being dragged.
struct HandleState {
  struct Going {
    Document before;
    size_t edit = 0;  ///< its place in the list
    ShapeHandle::What what = ShapeHandle::What::Middle;
    std::array<float, 2> offset{};  ///< from the handle to where it was taken hold of
  };
  std::optional<Going> going;
};

}  // namespace swaplight
