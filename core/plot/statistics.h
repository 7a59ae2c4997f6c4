#pragma once

#include <cstddef>
#include <vector>

#include "core/base/json_fwd.h"

namespace swaplight {

/// What a box plot and a table say about many values.
struct Statistics {
  size_t count = 0;                      ///< of the finite values, which alone are counted
  size_t notFinite = 0;                  ///< values left out
  double mean = 0, median = 0, std = 0;  ///< std over the population
  double min = 0, max = 0;
  double p95 = 0, p99 = 0;
  double q1 = 0, q3 = 0;  ///< quartiles
  /// Tukey's whiskers: the outermost values within 1.5 (q3 - q1) of the box. What lies beyond is an outlier.
  double whiskerLow = 0, whiskerHigh = 0;
  size_t outliers = 0;
};

/// Percentiles interpolate linearly between the two nearest values (as numpy does). All zero where no value
/// is finite.
[[nodiscard]] Statistics statisticsOf(std::vector<float> values);

/// The value below which `percent` (0..100) of the sorted values lie, interpolated linearly.
[[nodiscard]] double percentileOfSorted(const std::vector<float>& sorted, double percent);

[[nodiscard]] Json jsonFromStatistics(const Statistics& statistics);

}  // namespace swaplight
