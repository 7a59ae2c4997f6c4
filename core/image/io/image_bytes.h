#pragma once

#include <string>

#include "core/image/image.h"

namespace swaplight {

/// A picture of code values 0..1 (R G B) as the bytes of a PNG or JPEG file. Throws InputError where it
/// cannot be encoded.
[[nodiscard]] std::string pngBytes(const Image& image);
[[nodiscard]] std::string jpegBytes(const Image& image, int quality = 88);

}  // namespace swaplight
