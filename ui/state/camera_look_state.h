#pragma once

#include <map>
#include <string>

#include "ui/state/curve_grab.h"

namespace swaplight {

/// What the panel of the camera look remembers between frames and nobody saves.
struct CameraLookState {
  int chosen = -1;                          ///< the filter in focus, whose parameters are shown
  std::string search;                       ///< in the library
  std::map<std::string, CurveGrab> curves;  ///< of the filter in focus, by parameter
};

/// What is dragged from the library: a filter's name.
inline constexpr const char* kDraggedFilter = "swaplight filter";

}  // namespace swaplight
