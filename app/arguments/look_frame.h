#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/filter/filtered_image.h"
#include "core/image/images_in_files.h"
#include "core/image/io/carried_data.h"

namespace swaplight {

struct ReadFrame {
  FilteredImage frame;
  std::shared_ptr<const CarriedData> carried;  ///< what else the file holds; null: nothing
  std::vector<std::string> warnings;
};

/// R, G, B, and A where it is wanted (the file's own, or 1; not multiplied in, as an EXR and some TIFFs
/// have it). Floats and
/// raw files hold light, others codes. Throws InputError.
[[nodiscard]] ReadFrame readFrame(const std::filesystem::path& file, bool alpha);

/// While it lives, pictures as large as a part of a frame lie in memory, larger ones beside the result.
[[nodiscard]] std::unique_ptr<const ImagesInFiles> largeImagesBeside(const std::filesystem::path& output,
                                                                     int partSide);

}  // namespace swaplight
