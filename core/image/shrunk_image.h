#pragma once

#include "core/image/image.h"

namespace swaplight {

/// An image made smaller: each pixel is the mean of those that it covers. At least 1 x 1.
[[nodiscard]] Image shrunkImage(const Image& image, int width, int height);

}  // namespace swaplight
