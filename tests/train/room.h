#pragma once

#include "tests/train/stage.h"

namespace training {

/// A room with a window, or a corridor with doors and windows, and its lamps: one often shines in from
/// outside.
void drawRoom(Stage& stage, bool corridor);

}  // namespace training
