#pragma once

#include <array>
#include <vector>

namespace swaplight {

using CurvePoints = std::vector<std::array<float, 2>>;

/// A curve's points while one of them is held by the mouse.
struct CurveGrab {
  int held = -1;       ///< of `before`
  CurvePoints before;  ///< when the button went down, with the new point, where it made one
};

}  // namespace swaplight
