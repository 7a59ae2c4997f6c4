#pragma once

#include <string>
#include <vector>

#include "app/program/description.h"
#include "core/base/progress.h"

namespace swaplight {

/// Measures the hard-case suite, and the captures (with truth) that are named; says so in tables. `quick`:
/// small pictures.
[[nodiscard]] Description benchHardCases(const std::vector<std::string>& captures, unsigned seed, bool quick,
                                         const Progress& progress);

}  // namespace swaplight
