#include "core/plot/statistics.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

#include "core/base/json.h"

namespace swaplight {

double percentileOfSorted(const std::vector<float>& sorted, double percent) {
  if (sorted.empty()) return 0;
  const double position = percent / 100 * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<size_t>(position);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  const double fraction = position - static_cast<double>(below);
  return sorted[below] + fraction * (static_cast<double>(sorted[above]) - sorted[below]);
}

Statistics statisticsOf(std::vector<float> values) {
  Statistics s;
  const size_t all = values.size();
  std::erase_if(values, [](float v) { return !std::isfinite(v); });
  s.count = values.size();
  s.notFinite = all - s.count;
  if (values.empty()) return s;
  tbb::parallel_sort(values.begin(), values.end());

  double sum = 0;
  for (const float v : values) sum += v;
  s.mean = sum / static_cast<double>(s.count);
  double squares = 0;
  for (const float v : values) squares += (v - s.mean) * (v - s.mean);
  s.std = std::sqrt(squares / static_cast<double>(s.count));

  s.min = values.front();
  s.max = values.back();
  s.q1 = percentileOfSorted(values, 25);
  s.median = percentileOfSorted(values, 50);
  s.q3 = percentileOfSorted(values, 75);
  s.p95 = percentileOfSorted(values, 95);
  s.p99 = percentileOfSorted(values, 99);

  const double reach = 1.5 * (s.q3 - s.q1);
  const auto low = std::lower_bound(values.begin(), values.end(), static_cast<float>(s.q1 - reach));
  const auto high = std::upper_bound(low, values.end(), static_cast<float>(s.q3 + reach));
  s.whiskerLow = *low;
  s.whiskerHigh = *(high - 1);
  s.outliers = static_cast<size_t>((low - values.begin()) + (values.end() - high));
  return s;
}

Json jsonFromStatistics(const Statistics& s) {
  return {
      {"mean", s.mean},
      {"median", s.median},
      {"p95", s.p95},
      {"p99", s.p99},
      {"max", s.max},
      {"min", s.min},
      {"std", s.std},
      {"q1", s.q1},
      {"q3", s.q3},
      {"whisker_low", s.whiskerLow},
      {"whisker_high", s.whiskerHigh},
      {"outliers", s.outliers},
      {"outlier_fraction", s.count > 0 ? static_cast<double>(s.outliers) / static_cast<double>(s.count) : 0.},
      {"count", s.count},
      {"not_finite", s.notFinite}};
}

}  // namespace swaplight
