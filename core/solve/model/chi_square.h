#pragma once

#include <cmath>

namespace swaplight {

// Chi-square by a normal variable (Wilson and Hilferty, "The distribution of chi-square", PNAS 17, 1931): its
// cube root over its mean is nearly normal. Degrees of freedom, above 0, need not be whole; from one on
// quantiles between .05 and .95 are right to some hundredths of the mean.

/// The quantile of chi-square over its mean; `normal`: the same quantile of a normal variable.
[[nodiscard]] inline double chiSquareQuantile(double freedom, double normal) {
  const double spread = 2 / (9 * freedom);
  return std::pow(1 - spread + normal * std::sqrt(spread), 3);
}

/// The inverse: the normal variable that is as likely as chi-square at `ratio` times its mean.
[[nodiscard]] inline double normalOfChiSquare(double freedom, double ratio) {
  const double spread = 2 / (9 * freedom);
  return (std::cbrt(ratio) - 1 + spread) / std::sqrt(spread);
}

[[nodiscard]] inline double medianChiSquare(double freedom) {
  return freedom * chiSquareQuantile(freedom, 0);
}

}  // namespace swaplight
