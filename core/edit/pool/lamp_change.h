#pragma once

namespace swaplight {

/// What is done to a light's lamp after the set was photographed. Lengths are widths of the picture at the
/// depth of what the lamp lights. A lamp of which nothing is said stays as it is.
struct LampChange {
  float right = 0;     ///< the lamp moved to the right; it keeps its direction
  float up = 0;        ///< the lamp moved up; it keeps its direction
  float distance = 1;  ///< times its distance from the middle of what it lights; its power stays
  float pan = 0;       ///< degrees that its beam swings to the right
  float tilt = 0;      ///< degrees that its beam swings up
  float spread = 1;    ///< times the width of its beam; the level in the middle stays
  float size = 1;      ///< times the diameter of its front; its power stays
  float diameter = 0;  ///< of its front before that, over its distance from what it lights; 0: not known
  bool operator==(const LampChange&) const = default;

  [[nodiscard]] bool isNeutral() const {
    LampChange change = *this;
    change.diameter = 0;
    return change == LampChange();
  }
};

}  // namespace swaplight
