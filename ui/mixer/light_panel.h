#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// The colour of the chosen light: hue wheel, numbers, temperature. Fills the width it is given.
void drawLightPanel(StudioContext& studio);
/// The height that it needs.
[[nodiscard]] float lightPanelHeight();

}  // namespace swaplight
