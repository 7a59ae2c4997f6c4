#pragma once

#include <cstddef>
#include <vector>

#include "core/base/progress.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// Single pixels within a highlight in which noise hides it, or lets another light look like a shadow, would
/// shine as they are where the highlight is taken away. One that most of its neighbours surround gets what
/// its light has beyond theirs without highlights, of that light that has one around; a few rounds. `kept`:
/// of each pixel, whether it has highlights; those that get one are added. Returns how many. Throws
/// Stopped.
size_t fillHighlightHoles(SolvedSet& set, std::vector<bool>& kept, const Progress& progress = {});

}  // namespace swaplight
