#pragma once

namespace swaplight {

/// What the mouse does in the viewer.
enum class Tool {
  Look,     ///< moves the picture
  Neutral,  ///< the pixel under it becomes neutral
  Match,    ///< the chosen light takes the colour of the pixel under it
  Brush,    ///< paints with the chosen light
  Stencil,  ///< lays the chosen light on through a shape
  Select,   ///< selects what edits are restricted to
  Region,   ///< draws the rectangle that scopes look at
};

}  // namespace swaplight
