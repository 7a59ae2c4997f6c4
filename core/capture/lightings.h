#pragma once

#include <vector>

#include "core/capture/capture.h"

namespace swaplight {

/// Stops, either way: no camera's exposures span so much.
constexpr double kMostExposureStops = 40;

/// Whether the lights had the same colours in both shots, as far as is told: known ones are equal, unknown
/// ones have one name; and both were crossed, or neither. Exposures may differ.
[[nodiscard]] bool litAlike(const Shot& a, const Shot& b);

/// Which lighting every shot is of: 0, 1 ... in the order of their first shots. Shots of one lighting are a
/// bracket: the same light at several exposures.
[[nodiscard]] std::vector<int> lightingsOf(const std::vector<Shot>& shots);

}  // namespace swaplight
