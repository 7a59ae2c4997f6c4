#pragma once

#include <string>

#include "ui/brush_state.h"
#include "ui/selection_state.h"
#include "ui/stencil_state.h"

namespace swaplight {

/// What the panel of the edits remembers between frames and nobody saves.
struct EditsState {
  BrushState brush;
  StencilState stencil;
  SelectionState selection;
  int chosen = -1;    ///< edit of the list; -1: none
  int renaming = -1;  ///< the edit whose name is being typed
  bool nameFocused = false;
  std::string name;  ///< what has been typed
};

}  // namespace swaplight
