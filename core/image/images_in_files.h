#pragma once

#include <cstddef>
#include <filesystem>
#include <thread>

namespace swaplight {

/// What of images lies in memory, in bytes; the rest lies in files.
struct ImageMemory {
  static constexpr size_t kAny = ~size_t{0};
  size_t largest = kAny;  ///< of one image
  size_t all = kAny;      ///< of all images together, but for small ones
  size_t ofFiles = 0;     ///< of what is being worked on of those in files: more is handed back
};

/// As long as one lives, images that do not fit into `memory` lie in temporary files of `folder`: for
/// pictures larger than the machine's memory. They are mapped, so that all that works on images works on
/// these; what of them has been touched is handed back to the system's file cache, within milliseconds, which
/// writes it out when something else wants the memory. The files have no name: they are gone with their
/// image, and with the program however it ends. One at a time; images may outlive it. That it changes what
/// all of the program does is on purpose: images are made in too many places to hand it to each.
///
/// Making such an image throws MachineError that names the folder: the disk is full, it cannot be written.
class ImagesInFiles {
 public:
  ImagesInFiles(const std::filesystem::path& folder, const ImageMemory& memory);
  ImagesInFiles(const ImagesInFiles&) = delete;
  ImagesInFiles& operator=(const ImagesInFiles&) = delete;
  ~ImagesInFiles();

  /// How many images lie in files now.
  [[nodiscard]] static size_t count();
  /// Whether all images together may be larger than the machine's memory: there is a limit for them.
  [[nodiscard]] static bool areBounded();

 private:
  std::jthread m_handingBack;
};

/// Memory for `floats` of an image, or for those of a file. Throws std::bad_alloc, MachineError.
[[nodiscard]] float* allocateImage(size_t floats);
void freeImage(float* pixels);

}  // namespace swaplight
