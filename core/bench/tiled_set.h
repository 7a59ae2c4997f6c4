#pragma once

#include "core/set/solved_set.h"

namespace swaplight {

/// A set of another size, made of mirrored copies side by side: for measuring how fast large sets are shown.
[[nodiscard]] SolvedSet tiledSet(const SolvedSet& set, int width, int height);

}  // namespace swaplight
