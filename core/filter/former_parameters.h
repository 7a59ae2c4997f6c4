#pragma once

#include "core/filter/filter_pipeline.h"

namespace swaplight {

/// Parameters of the program's own filters that are vectors, matrices and curves today and were numbers and
/// colours once, under other names: as they are now. Files and command lines with the former ones go on being
/// read.
[[nodiscard]] FilterStage withoutFormerParameters(FilterStage stage);

}  // namespace swaplight
