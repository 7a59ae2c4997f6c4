#pragma once

#include <imgui.h>

#include <span>
#include <string>

#include "ui/state/curve_grab.h"

namespace swaplight {

/// How a curve is drawn.
struct CurveLook {
  ImVec2 size;
  std::span<const float> histogram = {};  ///< behind it, heights 0..1
  std::string name = "curve";             ///< of the field and its points, for tests
  std::string tip = {};                   ///< what x and y are
  size_t mostPoints = 1000;
};

/// A curve over 0..1 (curveTable()). A click adds a point, a drag moves it, a double-click or a drag out of
/// the field removes it. True in the frames in which the points change.
[[nodiscard]] bool curveWidget(CurvePoints& points, CurveGrab& grab, const CurveLook& look);

}  // namespace swaplight
