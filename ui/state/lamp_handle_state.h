#pragma once

#include <array>
#include <memory>
#include <optional>

#include "core/edit/apply/prepared_edit.h"
#include "core/session/document.h"

namespace swaplight {

/// The middle of a light's pool that is being dragged: its lamp follows.
struct LampHandleState {
  struct Going {
    Document before;
    size_t edit = 0;                ///< its place in the list
    std::array<float, 2> shown{};   ///< where the handle was drawn, pixels of the picture
    std::array<float, 2> offset{};  ///< from there to where it was taken hold of
    std::array<float, 2> beyond{};  ///< from there to its own place, where it waited at the viewer's edge
  };
  std::optional<Going> going;
  std::shared_ptr<const PreparedEdit> shown;  ///< what is drawn until the next one runs
};

}  // namespace swaplight
