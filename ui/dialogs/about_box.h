#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// What this program is, who computes the picture, and what it is made of.
void drawAboutBox(StudioContext& studio, bool* open);

}  // namespace swaplight
