#pragma once

#include <filesystem>

#include "core/filter/filtered_image.h"

namespace swaplight {

/// R, G, B, and A where it is wanted (the file's own, or 1). Floats and raw files hold light, others codes.
/// Throws InputError.
[[nodiscard]] FilteredImage readFrame(const std::filesystem::path& file, bool alpha);

}  // namespace swaplight
