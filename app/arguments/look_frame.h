#pragma once

#include <filesystem>
#include <memory>

#include "core/filter/filtered_image.h"
#include "core/image/images_in_files.h"

namespace swaplight {

/// R, G, B, and A where it is wanted (the file's own, or 1). Floats and raw files hold light, others codes.
/// Throws InputError.
[[nodiscard]] FilteredImage readFrame(const std::filesystem::path& file, bool alpha);

/// While it lives, pictures as large as a part of a frame lie in memory, larger ones beside the result.
[[nodiscard]] std::unique_ptr<const ImagesInFiles> largeImagesBeside(const std::filesystem::path& output,
                                                                     int partSide);

}  // namespace swaplight
