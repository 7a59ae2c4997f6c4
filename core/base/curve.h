#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace swaplight {

using CurvePoints = std::vector<std::array<float, 2>>;

/// A smooth curve through points that never overshoots them: piecewise cubic Hermite with the slopes of
/// Fritsch and Carlson (Monotone Piecewise Cubic Interpolation, SIAM J. Numer. Anal. 17(2), 1980); constant
/// beyond the first and the last point. Returns `count` values for x = 0 .. 1. Throws InputError unless there
/// are points with finite, strictly ascending x.
[[nodiscard]] std::vector<float> curveTable(const CurvePoints& points, int count);

/// That curve's slope at each of its points. Throws as curveTable() does.
[[nodiscard]] std::vector<double> curveSlopes(const CurvePoints& points);

/// Such a table's value at beta, clamped to 0..1; linear between its entries.
[[nodiscard]] inline float curveAt(std::span<const float> table, float beta) {
  const float position = std::clamp(beta, 0.f, 1.f) * static_cast<float>(table.size() - 1);
  const auto below = std::min(static_cast<size_t>(position), table.size() - 2);
  const float fraction = position - static_cast<float>(below);
  return table[below] + fraction * (table[below + 1] - table[below]);
}

}  // namespace swaplight
