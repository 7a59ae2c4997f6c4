#pragma once

#include "ui/control/lights_context.h"

namespace swaplight {

/// The colour of the chosen light: a disc of hue and saturation, numbers, swatches, temperature, gel. Fills
/// the width it is given.
void drawLightPanel(LightsContext& studio);
/// The height that it needs.
[[nodiscard]] float lightPanelHeight();

}  // namespace swaplight
