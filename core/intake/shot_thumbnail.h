#pragma once

#include <vector>

#include "core/capture/capture_pixels.h"
#include "core/image/small_picture.h"

namespace swaplight {

/// Pictures of the shots, at most so wide and high, all with one gain that makes the brightest of them well
/// exposed: dark raw files are seen, and the shots can be compared.
[[nodiscard]] std::vector<SmallPicture> shotThumbnails(const CapturePixels& pixels, int width, int height);

}  // namespace swaplight
