#pragma once

#include "core/edit/pool/lamp_model.h"

namespace swaplight {

// What a hand does that takes hold of a light's pool and drags it: by its middle, or by a ring around that.

/// A place of the plane that stands for the set (lamp_model.h): widths of the picture, x to the right and y
/// up from its middle.
struct PlanePoint {
  double x = 0, y = 0;
};

/// What of a light the hand needs to know.
struct LampInHand {
  LampModel lamp;
  double width = 1;  ///< of what it lights, widths of the picture
};

/// Where the middle of what the lamp lights lies after a change; where its axis hardly meets the plane, or no
/// longer does, far out on the side that it points to.
[[nodiscard]] PlanePoint middleOf(const LampModel& lamp, const LampChange& change);

/// The change that brings that middle to a place by moving the lamp.
[[nodiscard]] LampChange movedTo(const LampModel& lamp, const PlanePoint& place);
/// The same by turning it.
[[nodiscard]] LampChange turnedTo(const LampModel& lamp, const PlanePoint& place);

/// Where the ring is held that stands for the breadth of the beam, half way out in what the lamp lights: on
/// the side of the picture's middle, so that it is seen.
[[nodiscard]] PlanePoint ringHandle(const LampInHand& held, double spread);
/// The spread that brings the ring through a place.
[[nodiscard]] double spreadThrough(const LampInHand& held, const PlanePoint& place);

}  // namespace swaplight
