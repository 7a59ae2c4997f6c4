#pragma once

#include "core/image/image.h"

namespace swaplight {

/// Turns a picture as the camera held it into an upright one. `exif` is EXIF's Orientation tag (TIFF 6.0): 1
/// is upright, 6 has to be turned clockwise, 8 anti-clockwise; others than 2..8 change nothing.
[[nodiscard]] Image uprightImage(Image&& image, int exif);

/// True where width and height change places.
[[nodiscard]] inline bool turnsBySide(int exif) {
  return exif >= 5 && exif <= 8;
}

}  // namespace swaplight
