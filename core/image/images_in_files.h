#pragma once

#include <cstddef>
#include <filesystem>
#include <thread>

namespace swaplight {

/// As long as one lives, images that take more than `largerThan` bytes lie in temporary files of `folder`
/// instead of memory: for pictures larger than that. They are mapped, so that all that works on images works
/// on these; what of them has been touched is handed back to the system's file cache many times a second,
/// which writes it out when something else wants the memory. The files have no name: they are gone with their
/// image, and with the program however it ends. One at a time; images may outlive it. That it changes what
/// all of the program does is on purpose: images are made in too many places to hand it to each.
///
/// Making such an image throws MachineError that names the folder: the disk is full, it cannot be written.
class ImagesInFiles {
 public:
  ImagesInFiles(const std::filesystem::path& folder, size_t largerThan);
  ImagesInFiles(const ImagesInFiles&) = delete;
  ImagesInFiles& operator=(const ImagesInFiles&) = delete;
  ~ImagesInFiles();

  /// How many images lie in files now.
  [[nodiscard]] static size_t count();

 private:
  std::jthread m_handingBack;
};

/// Memory for `floats` of an image, or for those of a file. Throws std::bad_alloc, MachineError.
[[nodiscard]] float* allocateImage(size_t floats);
void freeImage(float* pixels);

}  // namespace swaplight
