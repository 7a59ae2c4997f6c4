#pragma once

#include <array>
#include <filesystem>

#include "core/image/image.h"

namespace swaplight {

/// The colour of a picture, whatever else its file holds: R, G, B; else r, g, b; else those of its one layer;
/// else grey (Y, L or a single channel, with or without alpha) in all three. Alpha is dropped and never
/// multiplied in. Throws InputError that names `file` and lists the channels.
[[nodiscard]] Image rgbImage(Image&& image, const std::filesystem::path& file);

/// The channels that rgbImage takes. Throws InputError as it does.
[[nodiscard]] std::array<int, 3> rgbChannels(const Image& image, const std::filesystem::path& file);

}  // namespace swaplight
