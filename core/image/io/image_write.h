#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/image/image_parts.h"

namespace swaplight {

/// Writes to a temporary name, then renames. Throws InputError where it cannot be written.
void writeChannels(const FileToWrite& contents, const std::filesystem::path& file,
                   const Progress& progress = {});

}  // namespace swaplight
