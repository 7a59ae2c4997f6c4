#pragma once

#include <cstdint>

#include "core/view/view_window.h"

namespace swaplight {

/// What the viewer has drawn last: for those who draw over it or ask what is under the mouse.
struct ShownPicture {
  bool valid = false;
  ViewWindow window;  ///< of the pane under the mouse, in pixels of the screen
  float originX = 0;  ///< the pane's corner on the screen
  float originY = 0;
  bool hovered = false;
  uint64_t revision = 0;  ///< of the document that it shows
};

}  // namespace swaplight
