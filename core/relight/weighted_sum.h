#pragma once

#include <cstddef>
#include <span>

namespace swaplight {

/// A row of pixels and the factor on it.
struct WeightedRow {
  const float* pixels;
  float factor;
};

/// out = sum of factor * pixels, for `count` pixels; 0 where there are no rows. Reads each row once, four at
/// a time, and `out` is neither read nor written more often than that takes.
void weightedSum(std::span<const WeightedRow> rows, ptrdiff_t count, float* out);

}  // namespace swaplight
