#pragma once

#include "core/solve/model/packed_run.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// About `count` usable pixels (none with a flag), spread evenly over the set in runs of a cache line.
/// `index` (may be null) receives where each was taken.
[[nodiscard]] PackedRun pixelSample(const ShotSignal& signal, int shots, size_t count,
                                    std::vector<size_t>* index = nullptr);

}  // namespace swaplight
