#include "core/solve/registration/moved_pixels.h"

#include <gtest/gtest.h>

#include "core/solve/solve.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

constexpr int kX = 40, kY = 16, kSize = 28;  // a patch of the picture

constexpr int kRim = 8;  // the detector's windows reach so far

bool inPatch(int x, int y, int rim = 0) {
  return x >= kX - rim && x < kX + kSize + rim && y >= kY - rim && y < kY + kSize + rim;
}

/// In the patch the last shot shows other pixels of the set.
void move(CapturePixels& pixels) {
  const Image before = pixels.shots.back().clone();
  for (int c = 0; c < 3; ++c)
    for (int y = kY; y < kY + kSize; ++y)
      for (int x = kX; x < kX + kSize; ++x)
        pixels.shots.back().span().at(c, x, y) = before.view().at(c, x + 37, y);
}

struct Marked {
  int all = 0;
  int inside = 0;
  int outside = 0;  ///< beyond the rim
};

Marked countMoved(const SolvedSet& set) {
  Marked count;
  for (int y = 0; y < set.height(); ++y)
    for (int x = 0; x < set.width(); ++x) {
      if (!(int(set.quality.view().at(kFlags, x, y)) & kMoved)) continue;
      ++count.all;
      count.inside += inPatch(x, y);
      count.outside += !inPatch(x, y, kRim);
    }
  return count;
}

TEST(MovedPixels, WhatMovedIsMarkedAndWhatShinesIsNot) {
  for (int lights : {2, 3}) {
    Capture capture = rotatedCapture(lights);
    capture.noise = SensorNoise{.002, 20000};
    const SyntheticSet truth(lights, 0.5F);
    CapturePixels pixels = photograph(capture, truth);
    const Marked still = countMoved(solve(capture, pixels, {}));
    EXPECT_EQ(still.all, 0) << lights;
    move(pixels);
    const SolvedSet set = solve(capture, pixels, {});
    const Marked moved = countMoved(set);
    printf("%d lights: %d of %d marked, %d outside\n", lights, moved.inside, kSize * kSize, moved.outside);
    EXPECT_GT(moved.inside, kSize * kSize / 2) << lights;
    EXPECT_EQ(moved.outside, 0) << lights;
    EXPECT_EQ(set.report->moved, size_t(moved.all));
  }
}

TEST(MovedPixels, FewerShotsThanLightsCannotTellMotionFromGloss) {
  Capture capture = rotatedCapture(3);
  capture.noise = SensorNoise{.002, 20000};
  capture.shots.pop_back();
  CapturePixels pixels = photograph(capture, SyntheticSet(3, 0.5F));
  move(pixels);
  EXPECT_EQ(countMoved(solve(capture, pixels, {})).all, 0);
}

}  // namespace
}  // namespace swaplight
