#pragma once

#include "ui/control/lights_context.h"

namespace swaplight {

/// Colours that were kept and those used last, in one line that fills the width: a click gives one to the
/// lights. What finds no room is behind the line's last button. Remembers `color`, the light's, as used once
/// it stays.
void drawSwatchRow(LightsContext& studio, size_t light, const LightColor& color);
[[nodiscard]] float swatchRowHeight();

}  // namespace swaplight
