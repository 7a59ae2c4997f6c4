#pragma once

#include <optional>

#include "core/shadow/result/shadow_outline.h"

namespace swaplight {

/// One connected shadow of a light: its umbra and penumbra.
struct ConnectedShadow {
  int x = 0, y = 0;  ///< the pixel deepest inside: the same for whichever pixel of the shadow was asked for
  size_t pixels = 0;
  std::vector<Outline> outline;
};

/// The shadow that holds a pixel; nothing where it is in none.
[[nodiscard]] std::optional<ConnectedShadow> connectedShadowAt(const LightShadows& shadows, int x, int y);

}  // namespace swaplight
