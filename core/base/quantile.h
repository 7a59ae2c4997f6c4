#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "core/base/check.h"

namespace swaplight {

/// The value below which the fraction q (0..1) of the values lies: that of rank floor(q n) among n values in
/// order, counted from 0 (the last for q = 1). Always one of the values, none is interpolated; the median of
/// an even number is the upper of the middle two. Linear in n: puts the values out of order, those from that
/// rank on are not below it. There must be a value, and none is NaN.
template <typename T>
[[nodiscard]] T quantile(std::span<T> values, double q) {
  SWAPLIGHT_CHECK(!values.empty());
  // Whole ranks are meant where q has no binary form: 0.29 of 100 is 29, not 28.
  const auto rank = static_cast<size_t>(q * static_cast<double>(values.size()) + 1e-9);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::min(rank, values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

template <typename T>
[[nodiscard]] T median(std::span<T> values) {
  return quantile(values, 0.5);
}

/// The same with what lies between two ranks interpolated: the q-quantile at q (n - 1), as numpy has it (type
/// 7 of Hyndman and Fan 1996).
template <typename T>
[[nodiscard]] double interpolatedQuantile(std::span<T> values, double q) {
  SWAPLIGHT_CHECK(!values.empty());
  const double position = q * static_cast<double>(values.size() - 1);
  const auto below = values.begin() + static_cast<std::ptrdiff_t>(position);
  std::nth_element(values.begin(), below, values.end());
  const double low = *below;
  if (below + 1 == values.end()) return low;
  const double high = *std::min_element(below + 1, values.end());
  return low + (position - static_cast<double>(below - values.begin())) * (high - low);
}

}  // namespace swaplight
