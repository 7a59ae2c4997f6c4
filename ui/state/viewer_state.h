#pragma once

#include <optional>

#include "core/view/scopes/scope_sample.h"

namespace swaplight {

/// What the viewer remembers between frames and nobody saves.
struct ViewerState {
  /// What a button that is held does.
  enum class Grab { None, Pan, WipeMove, WipeTurn, Exposure, Region };
  Grab grab = Grab::None;
  std::optional<PictureRegion> region;  ///< that scopes look at
  int regionX = 0, regionY = 0;         ///< where its drawing began
};

}  // namespace swaplight
