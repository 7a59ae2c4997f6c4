#pragma once

#include <optional>

#include "core/capture/capture_pixels.h"

namespace swaplight {

/// How much more exposed one picture is than another of the same lighting.
struct ExposureRatio {
  double stops = 0;
  double bend = 0;  ///< stops between its dark and its bright parts: 0 where the pictures are linear
};

/// The exposure of shot `b` over shot `a`, by means over small squares that are neither dark nor clipped in
/// either. One lighting's pictures are a function of each other, whatever the camera's curve: nothing is
/// returned where squares that are alike in one differ in the other, or too few can be compared.
[[nodiscard]] std::optional<ExposureRatio> exposureRatio(const CapturePixels& pixels, size_t a, size_t b);

}  // namespace swaplight
