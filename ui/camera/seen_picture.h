#pragma once

#include <optional>
#include <shared_mutex>
#include <string>

#include "core/image/image.h"
#include "core/view/pyramid.h"

namespace swaplight {

/// A frame under a camera look; a draft is smaller than the frame. What it holds changes in the window's
/// thread, with `mutex` locked: other threads lock it to read.
struct SeenPicture {
  mutable std::shared_mutex mutex;
  Image image;
  std::optional<Pyramid> pyramid;  ///< of the image
  std::string colorSpace;          ///< of light; empty: codes for a display
  float scale = 0;                 ///< of the image in the frame's size; 0: nothing is drawn yet
  int width = 0, height = 0;       ///< of the frame
};

/// A draft becomes as large as the frame, interpolated. For the window's thread.
void enlarge(SeenPicture& picture);

}  // namespace swaplight
