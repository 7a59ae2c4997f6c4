#pragma once

#include <filesystem>
#include <vector>

#include "core/image/small_picture.h"

namespace swaplight {

/// How each file that was open was lit last, small, for the page that the studio starts with: a PNG a
/// file in a folder, named by the file's path. What cannot be read or written is left out: it is worth no
/// message.
class KeptPictures {
 public:
  explicit KeptPictures(std::filesystem::path folder) : m_folder(std::move(folder)) {}

  void keep(const std::filesystem::path& file, const SmallPicture& picture) const;
  /// Where the picture of a file is, if one was kept.
  [[nodiscard]] std::filesystem::path pictureOf(const std::filesystem::path& file) const;
  /// Removes the pictures of all other files.
  void keepOnly(const std::vector<std::filesystem::path>& files) const;

 private:
  std::filesystem::path m_folder;
};

/// A picture file as it goes to the screen; empty where it cannot be read.
[[nodiscard]] SmallPicture readSmallPicture(const std::filesystem::path& file);

}  // namespace swaplight
