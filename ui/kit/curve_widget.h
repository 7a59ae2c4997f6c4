#pragma once

#include <imgui.h>

#include <array>
#include <span>
#include <vector>

namespace swaplight {

using CurvePoints = std::vector<std::array<float, 2>>;

/// A curve's points while one of them is held by the mouse.
struct CurveGrab {
  int held = -1;       ///< of `before`
  CurvePoints before;  ///< when the button went down, with the new point, where it made one
};

/// A curve of beta over beta, both 0..1, over the light's histogram (heights 0..1). A click adds a point, a
/// drag moves it, a double-click or a drag out of the field removes it. True in the frames in which the
/// points change.
[[nodiscard]] bool curveWidget(CurvePoints& points, CurveGrab& grab, std::span<const float> histogram,
                               ImVec2 size);

}  // namespace swaplight
