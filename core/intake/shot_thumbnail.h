#pragma once

#include <cstdint>
#include <vector>

#include "core/capture/capture_pixels.h"

namespace swaplight {

/// A small picture of a shot: 8-bit R G B A, sRGB.
struct ShotThumbnail {
  int width = 0, height = 0;
  std::vector<uint8_t> rgba;
};

/// Pictures of the shots, at most so wide and high, all with one gain that makes the brightest of them well
/// exposed: dark raw files are seen, and the shots can be compared.
[[nodiscard]] std::vector<ShotThumbnail> shotThumbnails(const CapturePixels& pixels, int width, int height);

}  // namespace swaplight
