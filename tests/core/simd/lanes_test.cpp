#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/simd/padding.h"
#include "tests/core/simd/kernels/lane_maths_kernel.h"
#include "tests/support/processor_levels.h"

namespace swaplight::test {
namespace {

// What core/simd/lanes.h claims.
constexpr double kLogarithmError = 1e-4;
constexpr double kExponentialError = 1e-5;

/// Positive normal numbers: 4096 of each power of two, the smallest, the largest, and those beside 1.
std::vector<float> positiveNumbers() {
  std::vector<float> numbers = {FLT_MIN, FLT_MAX, 1, std::nextafter(1.0F, 0.0F), std::nextafter(1.0F, 2.0F)};
  for (uint32_t bits = 0x00800000; bits < 0x7f800000; bits += 2048 + 1)
    numbers.push_back(std::bit_cast<float>(bits));
  numbers.resize(numbers.size() / kMostLanes * kMostLanes);
  return numbers;
}

/// What exponential() takes, -80 .. 80, and what lies just beyond.
std::vector<float> exponents() {
  std::vector<float> numbers = {0, -0.0F, -80, 80, std::nextafter(-80.0F, 0.0F), FLT_MIN, -FLT_MIN};
  constexpr int kSteps = 1 << 20;
  for (int i = 0; i <= kSteps; ++i) numbers.push_back(-80 + 160 * float(i) / kSteps);
  numbers.resize(numbers.size() / kMostLanes * kMostLanes);
  return numbers;
}

TEST(Lanes, TheLogarithmIsWithinTheErrorItClaimsOverAllPositiveNumbers) {
  const std::vector<float> in = positiveNumbers();
  std::vector<float> out(in.size());
  atEveryLevel([&] {
    SWAPLIGHT_KERNEL(logarithms)(in.data(), out.data(), int(in.size()));
    double worst = 0;
    for (size_t i = 0; i < in.size(); ++i)
      worst = std::max(worst, std::abs(out[i] - std::log(double(in[i]))));
    EXPECT_LT(worst, kLogarithmError);
    EXPECT_EQ(out[2], 0) << "of 1";
  });
}

TEST(Lanes, TheExponentialIsWithinTheRelativeErrorItClaims) {
  const std::vector<float> in = exponents();
  std::vector<float> out(in.size());
  atEveryLevel([&] {
    SWAPLIGHT_KERNEL(exponentials)(in.data(), out.data(), int(in.size()));
    double worst = 0;
    for (size_t i = 0; i < in.size(); ++i)
      worst = std::max(worst, std::abs(out[i] / std::exp(double(in[i])) - 1));
    EXPECT_LT(worst, kExponentialError);
    EXPECT_EQ(out[0], 1) << "of 0";
  });
}

TEST(Lanes, TheExponentialEndsWhereItSays) {
  const std::vector<float> in = {std::nextafter(-80.0F, -81.0F),
                                 -100,
                                 -1e30F,
                                 -INFINITY,
                                 -FLT_MAX,
                                 80,
                                 81,
                                 1e30F,
                                 FLT_MAX,
                                 INFINITY,
                                 0,
                                 0,
                                 0,
                                 0,
                                 0,
                                 0};
  std::vector<float> out(kMostLanes);
  atEveryLevel([&] {
    SWAPLIGHT_KERNEL(exponentials)(in.data(), out.data(), kMostLanes);
    for (size_t i = 0; i < 5; ++i) EXPECT_EQ(out[i], 0) << in[i];
    for (size_t i = 5; i < 10; ++i) EXPECT_NEAR(out[i] / std::exp(80.0), 1, kExponentialError) << in[i];
  });
}

TEST(Lanes, TheSquareRootIsThatOfLibm) {
  std::vector<float> in = positiveNumbers();
  in[0] = 0;
  std::vector<float> out(in.size());
  atEveryLevel([&] {
    SWAPLIGHT_KERNEL(squareRoots)(in.data(), out.data(), int(in.size()));
    for (size_t i = 0; i < in.size(); ++i) ASSERT_EQ(out[i], std::sqrt(in[i])) << in[i];
  });
}

TEST(Lanes, OneLaneIsEnoughForAny) {
  std::vector<float> in(kMostLanes, -1);
  atEveryLevel([&] {
    bool found = true;
    SWAPLIGHT_KERNEL(anyPositive)(in.data(), &found);
    EXPECT_FALSE(found);
    for (size_t lane = 0; lane < kMostLanes; ++lane) {
      in[lane] = 1;
      SWAPLIGHT_KERNEL(anyPositive)(in.data(), &found);
      EXPECT_TRUE(found) << lane;
      in[lane] = -1;
    }
  });
}

}  // namespace
}  // namespace swaplight::test
