#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/filter/frame_filter.h"
#include "core/ocio/color_config.h"
#include "core/session/document.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// A look or a version of a session's gallery, drawn.
struct GalleryPicture {
  std::string name, note;
  bool version = false;
  Image codes;  ///< R G B, display code values 0..1
};

struct GalleryOptions {
  int width = 480;  ///< of a picture, in pixels; smaller sets stay as they are
  /// Draws a camera look, which needs OpenGL; without it, or where it gives null, pictures are plain.
  std::function<std::shared_ptr<FrameFilter>(const FilterPipeline&)> cameraLook = {};
};

/// The gallery's pictures in its order, each as recalling it would show the frame: a version with its own
/// edits, camera look, view and grade, a look with those of the document. The frame is made whole, then
/// shrunk in light. What is for a display of high dynamic range is shown through the configuration's own
/// display. `set`: without the document's edits. Throws InputError that names the look; Stopped.
[[nodiscard]] std::vector<GalleryPicture> galleryPictures(const ColorConfig& config,
                                                          const std::shared_ptr<const SolvedSet>& set,
                                                          const Document& document,
                                                          const GalleryOptions& options,
                                                          const Progress& progress = {});

}  // namespace swaplight
