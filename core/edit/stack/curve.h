#pragma once

#include <array>
#include <vector>

namespace swaplight {

/// A smooth curve through points that never overshoots them: piecewise cubic Hermite with the slopes of
/// Fritsch and Carlson (Monotone Piecewise Cubic Interpolation, SIAM J. Numer. Anal. 17(2), 1980); constant
/// beyond the first and the last point. Returns `count` values for x = 0 .. 1. Throws InputError unless there
/// are points with finite, strictly ascending x.
[[nodiscard]] std::vector<float> curveTable(const std::vector<std::array<float, 2>>& points, int count);

}  // namespace swaplight
