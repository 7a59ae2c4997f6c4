#pragma once

#include "ui/control/viewer_context.h"

namespace swaplight {

/// All filters that there are, by categories, with a search. A click adds one; they can be dragged.
void drawFilterShelf(ViewerContext& studio);

}  // namespace swaplight
