#include "core/solve/auto/clipped_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/solve/solve.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

constexpr int kLights = 3;
constexpr size_t kHighlight = 20 * 128 + 30;  ///< its first pixel; kAcross pixels of a row belong to it
constexpr size_t kAcross = 4;

CapturePixels clipped(const Capture& capture, const SyntheticSet& truth) {
  CapturePixels pixels = photograph(capture, truth);
  for (size_t k = 0; k < pixels.shots.size(); ++k) {
    pixels.clipLevel[k] = 0.9999F;
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < pixels.shots[k].pixelCount(); ++p)
        pixels.shots[k].plane(c)[p] = std::min(pixels.shots[k].plane(c)[p], 1.0F);
  }
  return pixels;
}

SolvedSet solved(const Capture& capture, const CapturePixels& pixels, const SolveTuning& tuning = {}) {
  return solve(capture, pixels, {}, {}, tuning);
}

bool inHighlight(size_t pixel) {
  return pixel >= kHighlight && pixel < kHighlight + kAcross;
}

/// A rim of one light that all photographs show as white, on a ground where that light is the strongest.
SyntheticSet withRim(size_t light, float brightness) {
  SyntheticSet truth(kLights, 0);
  for (size_t i = 0; i < kLights; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = kHighlight - 3 * 128; p < kHighlight + 3 * 128; ++p) {
        float& value = truth.truth[i].plane(c)[p];
        value = i == light ? 0.3F : 0.02F;
        if (inHighlight(p)) value = i == light ? brightness : 0.02F;
      }
  return truth;
}

float sumOf(const SolvedSet& set, size_t light, size_t pixel) {
  float sum = 0;
  for (int c = 0; c < 3; ++c) sum += set.contributions[light].plane(c)[pixel];
  return sum;
}

TEST(ClippedLight, AHighlightOfOneLightIsNotSharedByAll) {
  const Capture capture = rotatedCapture(kLights);
  for (size_t light = 0; light < kLights; ++light) {
    const SolvedSet set = solved(capture, clipped(capture, withRim(light, 30)));
    for (size_t p = kHighlight; p < kHighlight + kAcross; ++p) {
      float all = 0;
      for (size_t i = 0; i < kLights; ++i) all += sumOf(set, i, p);
      EXPECT_GT(sumOf(set, light, p) / all, 0.8F);
      EXPECT_GT(set.beta.plane(int(light))[p], 0.8F);
      EXPECT_EQ(int(set.quality.plane(kFlags)[p]) & (kClipped | kFilled), kClipped | kFilled);
    }
  }
}

TEST(ClippedLight, TheLightClipsInEveryShotInWhichItDid) {
  const Capture capture = rotatedCapture(kLights);
  const SolvedSet set = solved(capture, clipped(capture, withRim(1, 30)));
  const LightingMatrix lighting = lightingFromCapture(capture);
  for (int k = 0; k < lighting.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      float light = 0;
      for (int i = 0; i < kLights; ++i)
        light += lighting.color(k, i)[c] * set.contributions[size_t(i)].plane(c)[kHighlight];
      EXPECT_GT(light, 0.98F) << k << c;
    }
}

TEST(ClippedLight, WhatIsNotClippedCounts) {
  // Bright enough to be clipped in most values, not in all: those that are left say how bright it is.
  const Capture capture = rotatedCapture(kLights);
  const SyntheticSet truth = withRim(0, 3);
  const CapturePixels pixels = clipped(capture, truth);
  const SolvedSet set = solved(capture, pixels);
  for (size_t p = kHighlight; p < kHighlight + kAcross; ++p) EXPECT_NEAR(sumOf(set, 0, p), 9, 0.9F);
}

TEST(ClippedLight, OtherPixelsStayAsTheyAre) {
  const Capture capture = rotatedCapture(kLights);
  const SyntheticSet truth = withRim(2, 30);
  const CapturePixels pixels = clipped(capture, truth);
  SolveTuning alike;
  alike.automatic.clipped.spread = 1e-3;
  const SolvedSet one = solved(capture, pixels), other = solved(capture, pixels, alike);
  for (size_t i = 0; i < kLights; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < one.beta.pixelCount(); ++p)
        if (!inHighlight(p)) {
          ASSERT_EQ(one.contributions[i].plane(c)[p], other.contributions[i].plane(c)[p]) << i << c << p;
        }
}

TEST(ClippedLight, ALightThatIsPhotographedAloneIsItsPhotograph) {
  Capture capture = rotatedCapture(kLights);
  for (size_t k = 0; k < kLights; ++k)
    for (size_t i = 0; i < kLights; ++i) capture.shots[k].lightColors[i] = Rgb(i == k ? 1.0F : 0.0F);
  const CapturePixels pixels = clipped(capture, withRim(1, 30));
  const SolvedSet set = solved(capture, pixels);
  for (size_t i = 0; i < kLights; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = kHighlight; p < kHighlight + kAcross; ++p)
        EXPECT_NEAR(set.contributions[i].plane(c)[p], pixels.shots[i].plane(c)[p], 1e-4);
}

TEST(ClippedLight, AllOfAPictureMayBeClipped) {
  const Capture capture = rotatedCapture(kLights);
  SyntheticSet truth(kLights, 0);
  for (Image& light : truth.truth) light = Image(light.spec(), 50);
  const SolvedSet set = solved(capture, clipped(capture, truth));
  for (const Image& light : set.contributions)
    for (size_t p = 0; p < light.pixelCount(); ++p) ASSERT_TRUE(std::isfinite(light.plane(0)[p]));
}

}  // namespace
}  // namespace swaplight
