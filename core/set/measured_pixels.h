#pragma once

#include "core/set/solved_set.h"

namespace swaplight {

/// Flags of a pixel whose light was not measured, or not all of it: clipped, moved, or filled in.
constexpr int kNotMeasured = kClipped | kMoved | kNotFinite | kFilled;

/// A set that says nothing of its quality counts as measured everywhere.
inline bool isMeasured(const SolvedSet& set, int x, int y) {
  return set.quality.empty() || (static_cast<int>(set.quality.view().at(kFlags, x, y)) & kNotMeasured) == 0;
}

}  // namespace swaplight
