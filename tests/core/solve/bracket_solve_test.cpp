#include <gtest/gtest.h>

#include <cmath>

#include "core/solve/solve.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

/// Swapped gels, both lightings at these exposures, clipped at full scale.
struct Bracketed {
  Capture capture;
  CapturePixels pixels;
};
Bracketed bracketed(const SyntheticSet& truth, std::initializer_list<float> stops) {
  Bracketed made;
  made.capture = rotatedCapture(2);
  made.capture.shots.clear();
  for (const Shot& lighting : rotatedCapture(2).shots)
    for (const float one : stops) {
      made.capture.shots.push_back(lighting);
      made.capture.shots.back().exposureStops = one;
    }
  made.pixels = photograph(made.capture, truth);
  for (size_t k = 0; k < made.pixels.shots.size(); ++k) {
    made.pixels.clipLevel[k] = 0.9999F;
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < made.pixels.shots[k].pixelCount(); ++p)
        made.pixels.shots[k].plane(c)[p] = std::min(made.pixels.shots[k].plane(c)[p], 1.0F);
  }
  return made;
}

double largestError(const SolvedSet& set, const SyntheticSet& truth) {
  double largest = 0;
  for (size_t i = 0; i < truth.truth.size(); ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < truth.truth[i].pixelCount(); ++p)
        largest = std::max(largest,
                           std::abs(double(set.contributions[i].plane(c)[p]) - truth.truth[i].plane(c)[p]));
  return largest;
}

size_t countOf(const SolvedSet& set, PixelFlag flag) {
  size_t count = 0;
  for (size_t p = 0; p < set.quality.pixelCount(); ++p)
    count += (int(set.quality.plane(kFlags)[p]) & flag) != 0;
  return count;
}

TEST(BracketSolve, ALongExposureThatIsClippedIsLeftToTheShorterOnes) {
  const SyntheticSet truth(2, 0);
  const Bracketed made = bracketed(truth, {0, 3, -2});
  for (const char* solver : {"maximum-likelihood", "demultiplex", "nnls", ""}) {
    SolveOptions options;
    options.solver = solver;
    const SolvedSet set = solve(made.capture, made.pixels, options);
    EXPECT_LT(largestError(set, truth), 5e-3) << solver;
    EXPECT_EQ(countOf(set, kClipped), 0U) << "no channel is clipped in all exposures of a lighting";
  }
}

TEST(BracketSolve, WhatIsClippedInAllExposuresIsAsBrightAsTheShortestSays) {
  SyntheticSet truth(2, 0);
  for (Image& light : truth.truth)
    for (int c = 0; c < 3; ++c) light.plane(c)[500] = 3;
  const Bracketed made = bracketed(truth, {0, 2});
  for (const char* solver : {"maximum-likelihood", "demultiplex", ""}) {
    SolveOptions options;
    options.solver = solver;
    const SolvedSet set = solve(made.capture, made.pixels, options);
    EXPECT_TRUE(int(set.quality.plane(kFlags)[500]) & kClipped);
    const auto sum = [&](int c) {
      return set.contributions[0].plane(c)[500] + set.contributions[1].plane(c)[500];
    };
    // 1 at exposure 0 under .9 and .15 of the lamps; by the longer exposure it would be a quarter of that.
    EXPECT_GT(sum(0), 0.8F) << solver;
  }
}

TEST(BracketSolve, AShortestExposureThatIsBrokenLeavesWhatTheNextOneSays) {
  SyntheticSet truth(2, 0);
  for (Image& light : truth.truth)
    for (int c = 0; c < 3; ++c) light.plane(c)[500] = 3;
  Bracketed made = bracketed(truth, {0, 2, -1});
  for (const size_t k : {size_t{2}, size_t{5}})
    for (int c = 0; c < 3; ++c) made.pixels.shots[k].plane(c)[500] = NAN;
  for (const char* solver : {"maximum-likelihood", "demultiplex"}) {
    SolveOptions options;
    options.solver = solver;
    const SolvedSet set = solve(made.capture, made.pixels, options);
    const float sum = set.contributions[0].plane(0)[500] + set.contributions[1].plane(0)[500];
    EXPECT_GT(sum, 0.8F) << solver;
  }
}

}  // namespace
}  // namespace swaplight
