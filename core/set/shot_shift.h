#pragma once

namespace swaplight {

/// Where a shot lies against the first: its pixel (u + x, v + y) shows what the first shows at (u, v).
struct ShotShift {
  float x = 0, y = 0;  ///< pixels
  bool found = true;   ///< false: the pictures would not be registered, x and y are 0
  /// How far the parts of the picture, each by itself, are from x and y: the camera moves all of them alike,
  /// other light does not. In standard deviations (1.48 of the median); 0 where there are too few to tell.
  float spreadX = 0, spreadY = 0;
};

}  // namespace swaplight
