#pragma once

#include "core/set/solved_set.h"

namespace swaplight {

/// Fills in a report's counts, medians and message from a set that is solved.
void summarize(const SolvedSet& set, SolveReport& report);

}  // namespace swaplight
