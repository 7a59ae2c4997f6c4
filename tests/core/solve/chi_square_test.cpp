#include "core/solve/model/chi_square.h"

#include <gtest/gtest.h>

namespace swaplight {
namespace {

constexpr double kFifth = -0.841621, kTwentieth = -1.644854, kMost = 1.644854;  // normal quantiles

// Against tables of chi-square: Abramowitz and Stegun, 26.8.
TEST(ChiSquare, QuantilesAreThoseOfTheTables) {
  EXPECT_NEAR(1 * chiSquareQuantile(1, kMost), 3.8415, .1);
  EXPECT_NEAR(4 * chiSquareQuantile(4, kFifth), 1.6488, .02);
  EXPECT_NEAR(10 * chiSquareQuantile(10, kTwentieth), 3.9403, .02);
  EXPECT_NEAR(100 * chiSquareQuantile(100, kMost), 124.342, .02);
  EXPECT_NEAR(medianChiSquare(1), .4549, .02);
  EXPECT_NEAR(medianChiSquare(6), 5.3481, .01);
}

TEST(ChiSquare, NormalOfAQuantileIsTheNormalQuantile) {
  for (const double freedom : {1., 2.5, 4., 60.})
    for (const double normal : {kTwentieth, kFifth, 0., kMost})
      EXPECT_NEAR(normalOfChiSquare(freedom, chiSquareQuantile(freedom, normal)), normal, 1e-9) << freedom;
}

}  // namespace
}  // namespace swaplight
