#pragma once

#include "core/solve/model/packed_run.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// Which pixels a sample takes.
enum class SamplePixels {
  Whole,   ///< usable in every shot
  Partial  ///< those too that lack some shots, where each channel has a value; what is left out is NaN
};

/// About `count` usable pixels, spread evenly over the set in runs of a cache line. May be empty: one shot
/// that is clipped everywhere leaves no whole pixel. `index` (may be null) receives where each was taken.
[[nodiscard]] PackedRun pixelSample(const ShotSignal& signal, int shots, size_t count,
                                    std::vector<size_t>* index = nullptr,
                                    SamplePixels which = SamplePixels::Whole);

}  // namespace swaplight
