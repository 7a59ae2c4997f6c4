#pragma once

#include <cstddef>
#include <optional>

#include "core/view/scopes/scope_sample.h"

namespace swaplight {

/// What the viewer remembers between frames and nobody saves.
struct ViewerState {
  /// What a button that is held does.
  enum class Grab { None, Pan, WipeMove, WipeTurn, Exposure, Region, Light };
  Grab grab = Grab::None;
  std::optional<PictureRegion> region;  ///< that scopes look at
  int regionX = 0, regionY = 0;         ///< where its drawing began
  /// The pixel that was asked last which light it is.
  struct LightAsked {
    int x = -1, y = -1;
    size_t clicks = 0;
  };
  LightAsked lightAsked;
  bool plain = false;                 ///< a key is held that shows the picture without its camera look
  std::optional<size_t> filterAlone;  ///< the filter of the camera look that is seen without the others
};

}  // namespace swaplight
