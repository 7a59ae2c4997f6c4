#pragma once

#include <optional>
#include <string>

#include "core/shadow/result/connected_shadow.h"

namespace swaplight {

/// What the page of the shadows remembers between frames and nobody saves.
struct ShadowState {
  bool outlines = true;  ///< are drawn over the picture
  /// The shadow that was clicked; nothing: all of the light's.
  std::optional<ConnectedShadow> chosen;
  std::string light;  ///< whose it is
};

}  // namespace swaplight
