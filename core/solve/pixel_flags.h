#pragma once

#include <cstdint>
#include <vector>

#include "core/capture/capture_pixels.h"
#include "core/set/shot_shift.h"
#include "core/set/solved_set.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

// What is known of a solved set's pixels beside their numbers: quality.flags, and what follows from them.

/// Writes the flags; returns the pixels that nothing is known of (no shot has a finite value in some
/// channel): one byte a pixel, or nothing where there are none. `tooDarkSigma`: sigma above which beta is no
/// answer.
[[nodiscard]] std::vector<uint8_t> writeFlags(const CapturePixels& pixels, const ShotSignal& signal,
                                              float tooDarkSigma, SolvedSet& set);

/// Pixels that a moved shot does not show are marked as filled in: from its edge.
void flagOutside(const std::vector<ShotShift>& shifts, SolvedSet& set);

/// A pixel too dark to tell is given its neighbours' beta; its light, such as it is, stays.
void fillDarkBeta(SolvedSet& set);

}  // namespace swaplight
