#pragma once

#include <cstdint>

#include "tests/train/scene.h"

namespace training {

/// The set of a seed: a room, a table top, a street, a figure, a corridor, foliage or a heap of solids, with
/// its camera and lamps. `aspect`: height of the picture over its width.
[[nodiscard]] Scene drawScene(uint32_t seed, float aspect);

}  // namespace training
