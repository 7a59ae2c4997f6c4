#pragma once

#include "core/base/json_fwd.h"
#include "ui/shell/studio.h"

namespace swaplight {

/// What is done to a picture of 3840 x 2160 beside painting strokes: a new light, selections, gradients and
/// stencils dragged, edits over all of it, other views of it. Returns, for each, the longest frame that it
/// made (for so long nothing else was answered) and how long it took until all of it was shown, in
/// milliseconds.
[[nodiscard]] Json benchTools(const StudioOptions& options);

}  // namespace swaplight
