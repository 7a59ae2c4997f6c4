#pragma once

#include <string>

#include "core/image/image.h"
#include "core/image/pixel_rect.h"

namespace swaplight {

/// The rectangle of an image. Throws InputError where it does not lie inside; `name` begins the message.
[[nodiscard]] Image croppedImage(const Image& image, const PixelRect& crop, const std::string& name);

}  // namespace swaplight
