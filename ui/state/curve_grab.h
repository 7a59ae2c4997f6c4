#pragma once

#include "core/base/curve.h"

namespace swaplight {

/// A curve's points while one of them is held by the mouse.
struct CurveGrab {
  int held = -1;       ///< of `before`
  CurvePoints before;  ///< when the button went down, with the new point, where it made one
};

}  // namespace swaplight
