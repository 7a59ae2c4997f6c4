#pragma once

#include <imgui.h>

#include <span>

#include "ui/state/curve_grab.h"

namespace swaplight {

/// A curve of beta over beta, both 0..1, over the light's histogram (heights 0..1). A click adds a point, a
/// drag moves it, a double-click or a drag out of the field removes it. True in the frames in which the
/// points change.
[[nodiscard]] bool curveWidget(CurvePoints& points, CurveGrab& grab, std::span<const float> histogram,
                               ImVec2 size);

}  // namespace swaplight
