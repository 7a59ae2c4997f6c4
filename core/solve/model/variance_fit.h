#pragma once

#include <array>
#include <span>

namespace swaplight {

/// A variance that was found at a signal.
struct VariancePoint {
  double signal = 0, variance = 0;
};

/// The largest variance constant + linear y (the sum of its logarithms over the points) that is above none of
/// the points: each of them is noise and perhaps something else.
[[nodiscard]] std::array<double, 2> varianceBelow(std::span<const VariancePoint> points);

/// constant, linear, square >= 0 of constant + linear y + square y^2 through the points, relative errors
/// counting alike in all of them.
[[nodiscard]] std::array<double, 3> fitVariance(std::span<const VariancePoint> points);

}  // namespace swaplight
