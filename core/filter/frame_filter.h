#pragma once

#include <functional>

#include "core/base/progress.h"
#include "core/filter/filter_pipeline.h"
#include "core/filter/filtered_image.h"

namespace swaplight {

/// A camera look as those who write frames know it. Its filters are shaders, of which core knows nothing:
/// render/filter has the one that draws them (CameraLook).
class FrameFilter {
 public:
  FrameFilter() = default;
  FrameFilter(const FrameFilter&) = delete;
  FrameFilter& operator=(const FrameFilter&) = delete;
  virtual ~FrameFilter() = default;

  /// The frame under the look. `displayFromScene` brings scene-linear light to display codes 0..1, in place,
  /// on R G B; it is called at most once. Grain and flicker follow from the frame's number. From any thread,
  /// several at a time. Throws InputError, ResourceError, Stopped.
  [[nodiscard]] virtual FilteredImage apply(FilteredImage frame,
                                            const std::function<void(ImageSpan)>& displayFromScene,
                                            int frameNumber, const Progress& progress = {}) = 0;
  [[nodiscard]] virtual const FilterPipeline& pipeline() const = 0;
  /// One of its filters asks for FilteredImage::light.
  [[nodiscard]] virtual bool wantsLight() const { return false; }
};

}  // namespace swaplight
