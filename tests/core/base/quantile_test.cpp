#include "core/base/quantile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace swaplight {
namespace {

std::vector<float> shuffled(int count) {
  std::vector<float> values;
  for (int i = 0; i < count; ++i) values.push_back(float(i));
  std::shuffle(values.begin(), values.end(), std::mt19937(3));
  return values;
}

TEST(Quantile, IsTheValueOfItsRank) {
  for (const int count : {1, 2, 3, 10, 100, 1001}) {
    std::vector<float> values = shuffled(count);
    EXPECT_EQ(quantile(std::span(values), 0), 0);
    EXPECT_EQ(quantile(std::span(values), 1), float(count - 1)) << "the last, not the one beyond";
    EXPECT_EQ(median(std::span(values)), float(count / 2)) << "of an even number the upper of the middle two";
  }
}

TEST(Quantile, HundredthsOfAHundredAreWholeRanks) {
  for (int percent = 0; percent < 100; ++percent) {
    std::vector<float> values = shuffled(100);
    EXPECT_EQ(quantile(std::span(values), percent / 100.0), float(percent)) << percent;
  }
}

TEST(Quantile, InterpolatesAsNumpyDoes) {
  std::vector<double> values = {3, 1, 4, 1, 5, 9, 2, 6};  // numpy.quantile(values, q)
  EXPECT_DOUBLE_EQ(interpolatedQuantile(std::span(values), .5), 3.5);
  EXPECT_DOUBLE_EQ(interpolatedQuantile(std::span(values), .9), 6.9);
  EXPECT_DOUBLE_EQ(interpolatedQuantile(std::span(values), 0), 1);
  EXPECT_DOUBLE_EQ(interpolatedQuantile(std::span(values), 1), 9);
}

TEST(Quantile, OfNothingIsAProgrammersMistake) {
  std::vector<float> none;
  EXPECT_THROW((void)median(std::span(none)), std::logic_error);
  EXPECT_THROW((void)interpolatedQuantile(std::span(none), .5), std::logic_error);
}

TEST(Check, SaysWhatWasExpectedAndWhatWasFound) {
  const std::vector<int> lights = {1, 2, 3};
  const size_t factors = 2;
  try {
    SWAPLIGHT_CHECK_EQ(factors, lights.size());
    FAIL() << "it does not hold";
  } catch (const std::logic_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("quantile_test.cpp"));
    EXPECT_THAT(error.what(), testing::HasSubstr("not factors == lights.size(): 2 and 3"));
  }
}

TEST(Check, EvaluatesOnceAndPassesWhatHolds) {
  int calls = 0;
  const auto next = [&] { return ++calls; };
  SWAPLIGHT_CHECK_LE(next(), 1);
  SWAPLIGHT_CHECK_LT(0, next());
  SWAPLIGHT_CHECK(next() == 3);
  EXPECT_EQ(calls, 3);
  EXPECT_THROW(SWAPLIGHT_CHECK(calls == 0), std::logic_error);
}

}  // namespace
}  // namespace swaplight
