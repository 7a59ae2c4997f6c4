#pragma once

#include "ui/control/viewer_context.h"

namespace swaplight {

/// The grade of the finished frame: wheels for lift, gamma and gain, saturation; the same as an ASC CDL.
void drawGradePanel(ViewerContext& studio);

}  // namespace swaplight
