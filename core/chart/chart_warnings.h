#pragma once

#include <string>
#include <vector>

#include "core/chart/chart_fit.h"

namespace swaplight {

/// What a person should know of the fit of a chart, a line each: patches that were not used, no matrix,
/// patches far off, uneven light, glare. `fit.warnings` is not read.
[[nodiscard]] std::vector<std::string> chartWarnings(const ChartFit& fit);

}  // namespace swaplight
