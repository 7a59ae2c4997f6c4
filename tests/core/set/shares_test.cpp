#include <gtest/gtest.h>

#include <random>

#include "core/set/shares_kernel.h"
#include "core/set/solved_set.h"
#include "tests/support/processor_levels.h"

namespace swaplight {
namespace {

/// Three planes a light of random light, some pixels dark.
std::vector<std::vector<float>> randomPlanes(int lights, size_t count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> value(0, 3);
  std::vector<std::vector<float>> planes(size_t(lights) * 3, std::vector<float>(count));
  for (std::vector<float>& plane : planes)
    for (size_t p = 0; p < count; ++p) plane[p] = p % 7 == 3 ? 0 : value(random);
  return planes;
}

TEST(Shares, AreEachLightsSumOverAllAtEveryLevel) {
  for (const int lights : {1, 2, 3, 4, 5, 9, 16})
    for (const size_t count : {size_t{1}, size_t{16}, size_t{47}, size_t{160}}) {
      const std::vector<std::vector<float>> planes = randomPlanes(lights, count);
      std::vector<std::vector<float>> shares(size_t(lights), std::vector<float>(count, -1));
      std::vector<const float*> in;
      std::vector<float*> out;
      for (const std::vector<float>& plane : planes) in.push_back(plane.data());
      for (std::vector<float>& plane : shares) out.push_back(plane.data());
      test::atEveryLevel([&] {
        sharesOf(lights, in.data(), out.data(), count);
        for (size_t p = 0; p < count; ++p) {
          double total = 0;
          for (const std::vector<float>& plane : planes) total += plane[p];
          for (size_t i = 0; i < size_t(lights); ++i) {
            const double own = double(planes[3 * i][p]) + planes[3 * i + 1][p] + planes[3 * i + 2][p];
            ASSERT_NEAR(shares[i][p], total > 0 ? own / total : 0, 1e-6) << lights << " lights, pixel " << p;
          }
        }
      });
    }
}

}  // namespace
}  // namespace swaplight
