#pragma once

#include "core/capture/capture_pixels.h"
#include "core/color/rgb.h"

namespace swaplight {

/// What crossed polarisers leave of matte light.
struct CrossedPass {
  Rgb part{1};            ///< of what arrives through open ones: > 0
  bool reversed = false;  ///< the crossed photographs are the brighter ones: their marks seem to be wrong
};

/// From the photographs alone: wherever the crossed photographs' lighting is a sum of the open ones', channel
/// by channel, so is their light but for the highlights, which crossed polarisers take away. The ratio of
/// blocks of pixels, both sides summed, is the part where a surface is matte and less where it is not: the
/// uppermost place where ratios gather is taken (mean shift from the upper decile: Fukunaga and Hostetler
/// 1975).
///
/// `capture` with crossed and with open shots, all colours known. Throws InputError: no lighting of a crossed
/// shot is a sum of the open ones', or too little light is in both.
[[nodiscard]] CrossedPass crossedPass(const Capture& capture, const CapturePixels& photographs);

}  // namespace swaplight
