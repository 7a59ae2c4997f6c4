#pragma once

#include "ui/control/lights_context.h"
#include "ui/mixer/mixer_card.h"

namespace swaplight {

/// The rows of `lights` lights where there is this much room, in pixels: narrow ones where wide ones would
/// have to be scrolled.
[[nodiscard]] const RowShape& rowShape(size_t lights, float room);
/// One light's row in the mixer.
void drawLightRow(LightsContext& studio, size_t light, const RowShape& shape);

}  // namespace swaplight
