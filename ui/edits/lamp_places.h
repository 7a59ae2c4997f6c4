#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// Where the lamps of the set's lights stood: what an edit that places one needs to know, light by light; and
/// what of that is missing, or how far finding the surfaces has come.
void drawLampPlaces(EditingContext& studio, const Edit& edit);

}  // namespace swaplight
