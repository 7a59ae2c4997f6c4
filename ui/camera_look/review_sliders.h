#pragma once

#include "ui/control/viewer_context.h"

namespace swaplight {

/// Brightness, contrast, saturation and sharpness of what is seen: the filter "review" at the end of the
/// look.
void drawReviewSliders(ViewerContext& studio);

}  // namespace swaplight
