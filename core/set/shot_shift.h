#pragma once

namespace swaplight {

/// Where a shot lies against the first: shifted, turned about the picture's middle, zoomed. What the first
/// shows at a place p, counted from the middle, the shot shows at zoom * p, turned, plus (x, y).
struct ShotShift {
  float x = 0, y = 0;  ///< pixels
  bool found = true;   ///< false: the pictures would not be registered, all else is at its default
  /// How far the parts of the picture, each by itself, are from that: the camera moves all of them alike,
  /// other light does not. In standard deviations (1.48 of the median); 0 where there are too few to tell.
  float spreadX = 0, spreadY = 0;
  float turn = 0;  ///< radians, clockwise as seen
  float zoom = 1;  ///< times as large

  [[nodiscard]] bool isTurned() const { return turn != 0 || zoom != 1; }
};

}  // namespace swaplight
