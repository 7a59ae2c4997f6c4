#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/image/io/image_io.h"

namespace swaplight {

/// As writeImage of image_io.h, and can be followed and stopped (Stopped) while it goes on.
void writeImage(const Image& image, const std::filesystem::path& file, const WriteOptions& options,
                const Progress& progress);

}  // namespace swaplight
