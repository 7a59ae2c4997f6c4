#pragma once

#include "core/image/image.h"
#include "ui/camera/seen_request.h"

namespace swaplight {

/// The set's frame as the request's lights light it, before any camera look: scene-linear, in the set's
/// colour space, `scale` times its size (at most 1); a side that is no whole number of pixels is rounded up.
/// From any thread.
[[nodiscard]] Image litFrame(const SeenRequest& request, float scale);

/// How much more light the request's lights give than at unit white: FilteredImage::light of the frame at
/// that scale. From any thread.
[[nodiscard]] Image relativeLight(const SeenRequest& request, float scale);

}  // namespace swaplight
