#pragma once

#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "core/view/view_window.h"
#include "core/view/window_pixels.h"

namespace swaplight {

/// How two pictures, A and B, are seen in one window.
struct Comparison {
  enum class Mode {
    Off,         ///< A alone
    Wipe,        ///< A on one side of a line, B on the other
    Difference,  ///< |A - B|, in linear light, before exposure and view
  };
  Mode mode = Mode::Off;
  // The wipe's line goes through a point of the picture, so that it stays there under zoom.
  double x = 0;
  double y = 0;
  double angleDegrees = 0;  ///< 0: the line is upright, B at its right; then clockwise
  bool operator==(const Comparison&) const = default;
};

/// B's side of a wipe in a window: where side.x * x + side.y * y + side.z >= 0, for a window pixel's centre.
[[nodiscard]] glm::dvec3 sideOfB(const Comparison& comparison, const ViewWindow& window);

/// The columns, first and behind the last, of a row of the window that show B.
[[nodiscard]] std::pair<int, int> columnsOfB(const glm::dvec3& side, int row, int width);

/// The layers whose sum is A - B.
[[nodiscard]] std::vector<ViewLayer> differenceLayers(const std::vector<ViewLayer>& a,
                                                      const std::vector<ViewLayer>& b);

}  // namespace swaplight
