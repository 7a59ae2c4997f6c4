#include "core/relight/weighted_sum.h"

#include <algorithm>
#include <array>

#include "core/simd/simd.h"

namespace swaplight {
namespace {

// Rows that are added up at a time: enough for most sets in one sweep, few enough to stay in registers.
constexpr size_t kRows = 4;

/// What is added up at a time. Missing rows have the factor 0 and repeat a row that is read anyway.
struct Sweep {
  std::array<const float*, kRows> rows;
  std::array<float, kRows> factors;
};

SWAPLIGHT_SIMD(void, setToSum, (float* __restrict out, const Sweep& sweep, ptrdiff_t count),
               (out, sweep, count)) {
  const auto [a, b, c, d] = sweep.rows;
  const auto [fa, fb, fc, fd] = sweep.factors;
  for (ptrdiff_t p = 0; p < count; ++p) out[p] = fa * a[p] + fb * b[p] + fc * c[p] + fd * d[p];
}

SWAPLIGHT_SIMD(void, addSum, (float* __restrict out, const Sweep& sweep, ptrdiff_t count),
               (out, sweep, count)) {
  const auto [a, b, c, d] = sweep.rows;
  const auto [fa, fb, fc, fd] = sweep.factors;
  for (ptrdiff_t p = 0; p < count; ++p) out[p] += fa * a[p] + fb * b[p] + fc * c[p] + fd * d[p];
}

SWAPLIGHT_SIMD(void, setToSumOfTwo, (float* __restrict out, const Sweep& sweep, ptrdiff_t count),
               (out, sweep, count)) {
  const float *a = sweep.rows[0], *b = sweep.rows[1];
  const float fa = sweep.factors[0], fb = sweep.factors[1];
  for (ptrdiff_t p = 0; p < count; ++p) out[p] = fa * a[p] + fb * b[p];
}

}  // namespace

void weightedSum(std::span<const WeightedRow> rows, ptrdiff_t count, float* out) {
  if (rows.empty()) std::fill_n(out, count, 0.0f);
  for (size_t first = 0; first < rows.size(); first += kRows) {
    Sweep sweep;
    for (size_t i = 0; i < kRows; ++i) {
      const bool missing = first + i >= rows.size();
      sweep.rows[i] = rows[missing ? first : first + i].pixels;
      sweep.factors[i] = missing ? 0 : rows[first + i].factor;
    }
    if (first == 0 && rows.size() <= 2)
      setToSumOfTwo(out, sweep, count);
    else
      (first == 0 ? setToSum : addSum)(out, sweep, count);
  }
}

}  // namespace swaplight
