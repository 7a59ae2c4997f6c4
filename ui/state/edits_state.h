#pragma once

#include <map>
#include <string>
#include <vector>

#include "ui/state/brush_state.h"
#include "ui/state/curve_grab.h"
#include "ui/state/handle_state.h"
#include "ui/state/lamp_handle_state.h"
#include "ui/state/selection_state.h"
#include "ui/state/shadow_state.h"
#include "ui/state/stencil_state.h"

namespace swaplight {

/// What the panel of the edits remembers between frames and nobody saves.
struct EditsState {
  BrushState brush;
  StencilState stencil;
  HandleState handle;
  LampHandleState lamp;
  SelectionState selection;
  ShadowState shadow;
  int chosen = -1;        ///< edit of the list; -1: none
  bool open = false;      ///< the chosen one shows all that can be changed, not only its opacity
  int closing = -1;       ///< an edit that was chosen: stays open while a double-click may follow
  double closesAt = 0;    ///< Dear ImGui's time
  bool settling = false;  ///< at that time the list scrolls to what the chosen edit shows
  bool focused = false;   ///< the list was clicked last: keys are for its chosen edit
  int renaming = -1;      ///< the edit whose name is being typed
  bool nameFocused = false;
  std::string name;        ///< what has been typed
  std::string placedLamp;  ///< the light whose lamp's place is told
  CurveGrab curve;
  std::map<int, std::vector<float>> histograms;  ///< of beta, by light; -1: all

  /// Something is being drawn or dragged in the picture.
  [[nodiscard]] bool dragging() const {
    return brush.going || stencil.going || handle.going || lamp.going || selection.going;
  }
  void endDrags() {
    brush.going.reset();
    stencil.going.reset();
    handle.going.reset();
    lamp.going.reset();
    selection.going.reset();
  }
};

}  // namespace swaplight
