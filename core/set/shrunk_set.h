#pragma once

#include "core/base/progress.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// A set made smaller, for those who need not look closely: every pixel is the mean of those that it covers
/// (shrunkImage), and as much surer than them. width, height: 1 .. those of the set. What the photographs'
/// files carried is left out.
[[nodiscard]] SolvedSet shrunkSet(const SolvedSet& set, int width, int height, const Progress& progress = {});

}  // namespace swaplight
