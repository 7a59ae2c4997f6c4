#include "core/plot/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace swaplight {
namespace {

// Figures of numpy 1.24: percentile(..., method="linear"), std(ddof=0).
TEST(Statistics, AgreeWithNumpy) {
  const Statistics s = statisticsOf({9, 2, 3, 5, 4, 100, 1, 8, 7, 6});
  EXPECT_EQ(s.count, 10u);
  EXPECT_DOUBLE_EQ(s.mean, 14.5);
  EXPECT_NEAR(s.std, 28.6051, 1e-4);
  EXPECT_DOUBLE_EQ(s.median, 5.5);
  EXPECT_DOUBLE_EQ(s.q1, 3.25);
  EXPECT_DOUBLE_EQ(s.q3, 7.75);
  EXPECT_NEAR(s.p95, 59.05, 1e-9);
  EXPECT_NEAR(s.p99, 91.81, 1e-9);
  EXPECT_EQ(s.min, 1);
  EXPECT_EQ(s.max, 100);
}

TEST(Statistics, WhiskersEndWithinTukeysReachAndTheRestAreOutliers) {
  const Statistics s = statisticsOf({9, 2, 3, 5, 4, 100, 1, 8, 7, 6});  // reach: 3.25 - 6.75 .. 7.75 + 6.75
  EXPECT_EQ(s.whiskerLow, 1);
  EXPECT_EQ(s.whiskerHigh, 9);
  EXPECT_EQ(s.outliers, 1u);
}

TEST(Statistics, ValuesThatAreNotFiniteAreLeftOutAndCounted) {
  const Statistics s = statisticsOf({NAN, 1, INFINITY, 3, -INFINITY});
  EXPECT_EQ(s.count, 2u);
  EXPECT_EQ(s.notFinite, 3u);
  EXPECT_EQ(s.mean, 2);
  EXPECT_EQ(s.max, 3);
}

TEST(Statistics, OneValueAndNoValueAreFine) {
  const Statistics one = statisticsOf({4});
  EXPECT_EQ(one.median, 4);
  EXPECT_EQ(one.p99, 4);
  EXPECT_EQ(one.std, 0);
  EXPECT_EQ(one.outliers, 0u);
  EXPECT_EQ(statisticsOf({}).count, 0u);
}

}  // namespace
}  // namespace swaplight
