#pragma once

#include <optional>

#include "core/edit/pool/lamp_model.h"

namespace swaplight {

// What a hand does that takes hold of the middle of a light's pool and drags it.

/// A place of the plane that stands for the set (lamp_model.h): widths of the picture, x to the right and y
/// up from its middle.
struct PlanePoint {
  double x = 0, y = 0;
};

/// Where the middle of what the lamp lights lies after a change; nothing where its axis no longer meets the
/// plane.
[[nodiscard]] std::optional<PlanePoint> middleOf(const LampModel& lamp, const LampChange& change);

/// The change that brings that middle to a place by moving the lamp.
[[nodiscard]] LampChange movedTo(const LampModel& lamp, const PlanePoint& place);
/// The same by turning it.
[[nodiscard]] LampChange turnedTo(const LampModel& lamp, const PlanePoint& place);

}  // namespace swaplight
