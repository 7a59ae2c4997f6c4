#include "core/relight/weighted_sum.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/support/processor_levels.h"

namespace swaplight {
namespace {

TEST(WeightedSum, IsThatOfDoublesForAnyNumberOfRowsAtEveryLevel) {
  constexpr size_t kCount = 133;  // no multiple of anything
  std::mt19937 random(2);
  std::uniform_real_distribution<float> value(-1, 3);
  std::vector<std::vector<float>> planes(17, std::vector<float>(kCount));
  for (std::vector<float>& plane : planes)
    for (float& v : plane) v = value(random);
  std::vector<WeightedRow> rows;
  for (size_t n = 0; n <= planes.size(); ++n) {
    std::vector<float> out(kCount + 1, 7);
    test::atEveryLevel([&] {
      weightedSum(rows, kCount, out.data());
      for (size_t p = 0; p < kCount; ++p) {
        double sum = 0;
        for (const WeightedRow& row : rows) sum += double(row.factor) * row.pixels[p];
        ASSERT_NEAR(out[p], sum, 1e-6 * double(n + 1) * 3) << n << " rows, pixel " << p;
      }
      ASSERT_EQ(out[kCount], 7) << "nothing is written beyond the row";
    });
    if (n < planes.size()) rows.push_back({planes[n].data(), value(random)});
  }
}

}  // namespace
}  // namespace swaplight
