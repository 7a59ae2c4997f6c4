#pragma once

#include <string>

#include "core/image/image.h"
#include "core/image/pixel_rect.h"

namespace swaplight {

/// The rectangle of an image. Throws InputError where it does not lie inside; `name` begins the message.
[[nodiscard]] Image croppedImage(const Image& image, const PixelRect& crop, const std::string& name);

/// The image as the rectangle of a larger one, which is 0 around it. The rectangle is of its size, and
/// inside.
[[nodiscard]] Image placedImage(const Image& image, const PixelRect& place, int width, int height);

}  // namespace swaplight
