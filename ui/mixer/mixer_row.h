#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// One light's row in the mixer.
void drawLightRow(StudioContext& studio, size_t light);

}  // namespace swaplight
