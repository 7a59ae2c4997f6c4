#include "core/solve/auto/separated_lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/solve/solve.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

constexpr int kLights = 3;

/// A shot a light, white; the others shine into it at `leak`.
Capture oneByOne(float leak) {
  Capture capture = rotatedCapture(kLights);
  for (size_t k = 0; k < kLights; ++k)
    for (size_t i = 0; i < kLights; ++i) capture.shots[k].lightColors[i] = Rgb(i == k ? 1.0F : leak);
  return capture;
}

double error(const SolvedSet& set, const SyntheticSet& truth) {
  double sum = 0, power = 0;
  for (size_t i = 0; i < kLights; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < truth.truth[i].pixelCount(); ++p) {
        const double t = truth.truth[i].plane(c)[p];
        sum += std::pow(set.contributions[i].plane(c)[p] - t, 2), power += t * t;
      }
  return std::sqrt(sum / power);
}

TEST(SeparatedLights, IsAllWhereEveryShotShowsOneLight) {
  EXPECT_EQ(separatedPart(lightingFromCapture(oneByOne(0))), 1);
  Capture colored = oneByOne(0);
  for (size_t k = 0; k < kLights; ++k) colored.shots[k].lightColors[k] = defaultColors()[k];
  EXPECT_EQ(separatedPart(lightingFromCapture(colored)), 1) << "whatever the light's colour";
  std::swap(colored.shots[0], colored.shots[2]);
  EXPECT_EQ(separatedPart(lightingFromCapture(colored)), 1) << "in any order";
  colored.shots.push_back(colored.shots[1]);
  EXPECT_EQ(separatedPart(lightingFromCapture(colored)), 1) << "and where one is photographed twice";
}

TEST(SeparatedLights, FallsToNothingAsTheLightsMix) {
  float last = 1;
  for (float leak = .002F; leak < .4F; leak += .002F) {
    const float part = separatedPart(lightingFromCapture(oneByOne(leak)));
    EXPECT_LE(part, last) << leak;
    EXPECT_GT(part, last - .05F) << leak << ": no step";
    last = part;
  }
  EXPECT_EQ(last, 0);
  EXPECT_EQ(separatedPart(lightingFromCapture(rotatedCapture(3))), 0);
}

TEST(SeparatedLights, IsNothingWhereTheShotsAreTooFewOrALightIsNotSeenInAChannel) {
  Capture few = oneByOne(0);
  few.shots.pop_back();
  EXPECT_EQ(separatedPart(lightingFromCapture(few)), 0);
  Capture red = oneByOne(0);
  red.shots[1].lightColors[1] = Rgb(1, 0, 0);
  EXPECT_EQ(separatedPart(lightingFromCapture(red)), 0) << "green and blue of it come from the matte model";
}

TEST(SeparatedLights, OneLightAtATimeIsThePhotographOfThatLight) {
  const SyntheticSet truth(kLights, .2F);
  for (const bool told : {true, false}) {
    Capture capture = oneByOne(0);
    capture.noise = SensorNoise{.004, 5000};
    const CapturePixels pixels = photograph(capture, truth);
    if (!told) capture.noise.reset();
    const SolvedSet set = solve(capture, pixels, {});
    for (size_t i = 0; i < kLights; ++i)
      for (int c = 0; c < 3; ++c)
        for (size_t p = 0; p < set.beta.pixelCount(); ++p)
          ASSERT_NEAR(set.contributions[i].plane(c)[p], std::max(pixels.shots[i].plane(c)[p], 0.0F), 1e-5F);
    EXPECT_LT(set.report->residualMedian, .1)
        << "highlights are no misfit of photographs that explain themselves";
  }
}

TEST(SeparatedLights, NothingIsLostOnTheWayFromSeparatedToMixed) {
  const SyntheticSet truth(kLights, .2F);
  for (float leak = 0; leak < .35F; leak += .05F) {
    Capture capture = oneByOne(leak);
    capture.noise = SensorNoise{.004, 5000};
    const CapturePixels pixels = photograph(capture, truth);
    SolveOptions options;
    const double ours = error(solve(capture, pixels, options), truth);
    options.model = Model::Transport;
    EXPECT_LT(ours, 1.02 * error(solve(capture, pixels, options), truth)) << leak;
    options.model = Model::Lambert;
    EXPECT_LT(ours, error(solve(capture, pixels, options), truth)) << leak;
  }
}

TEST(SeparatedLights, WhatIsClippedInTheOnlyPhotographOfALightIsWhatItShows) {
  const SyntheticSet truth(kLights, 0);
  const Capture capture = oneByOne(0);
  CapturePixels pixels = photograph(capture, truth);
  // Its hue under the other lights says nothing: they do not reach the pixel, but for a trace of noise.
  constexpr size_t kPixel = 777;
  for (int c = 0; c < 3; ++c) {
    pixels.shots[0].plane(c)[kPixel] = c == 0 ? 1.0F : .8F;
    pixels.shots[1].plane(c)[kPixel] = c == 0 ? 1e-3F : 1e-6F;
    pixels.shots[2].plane(c)[kPixel] = 0;
  }
  pixels.clipLevel[0] = 1;
  const SolvedSet set = solve(capture, pixels, {});
  EXPECT_FLOAT_EQ(set.contributions[0].plane(0)[kPixel], 1);
  EXPECT_TRUE(int(set.quality.plane(kFlags)[kPixel]) & kClipped);
}

TEST(SeparatedLights, ABrokenValueComesFromTheOtherLights) {
  const SyntheticSet truth(kLights, 0);
  const Capture capture = oneByOne(0);
  CapturePixels pixels = photograph(capture, truth);
  size_t p = 0;
  while (truth.truth[0].plane(0)[p] < .2F) ++p;
  pixels.shots[0].plane(0)[p] = NAN;
  const SolvedSet set = solve(capture, pixels, {});
  EXPECT_NEAR(set.contributions[0].plane(0)[p], truth.truth[0].plane(0)[p], .02F);
}

}  // namespace
}  // namespace swaplight
