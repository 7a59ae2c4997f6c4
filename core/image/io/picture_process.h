#pragma once

#include <memory>

#include "core/image/io/picture_source.h"
#include "core/sandbox/helper_processes.h"

namespace swaplight {

/// Decodes strangers' pictures in processes of their own as long as it lives, because a decoder that a
/// picture crashes or takes over then harms nothing (core/sandbox). Every openPicture() of this program goes
/// there. Make one, before any thread is started. Under the sanitizers it does nothing.
class PictureProcesses {
 public:
  PictureProcesses();
  PictureProcesses(const PictureProcesses&) = delete;
  PictureProcesses& operator=(const PictureProcesses&) = delete;
  ~PictureProcesses();
};

/// What decodes pictures now, in words for a report.
[[nodiscard]] const char* pictureProcessWords();

/// A picture in a process of its own; nothing where pictures are decoded in this one.
[[nodiscard]] std::unique_ptr<PictureSource> openPictureApart(const std::filesystem::path& file);

}  // namespace swaplight
