#include "core/solve/denoise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/solve/solve.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

constexpr int kEdgeColumn = 64;

/// A checked wall on which one light's shadow ends where the other's begins, so that their sum shows nothing.
SyntheticSet hiddenEdge() {
  SyntheticSet set(2, 0);
  for (int y = 0; y < set.height; ++y)
    for (int x = 0; x < set.width; ++x) {
      const float albedo = (x / 4 + y / 4) % 2 ? 0.35F : 0.55F;
      const float left = x < kEdgeColumn ? 0.65F : 0.35F;
      for (int c = 0; c < 3; ++c) {
        set.truth[0].span().at(c, x, y) = albedo * left;
        set.truth[1].span().at(c, x, y) = albedo * (1 - left);
      }
    }
  return set;
}

double columnMean(const SolvedSet& set, int x) {
  double sum = 0;
  for (int y = 0; y < set.height(); ++y) sum += set.beta.view().at(0, x, y);
  return sum / set.height();
}

/// RMS error of beta where nothing is near.
double flatError(const SolvedSet& set) {
  double sum = 0;
  int count = 0;
  for (int y = 0; y < set.height(); ++y)
    for (int x = 0; x < set.width(); ++x) {
      if (std::abs(x - kEdgeColumn) < 20) continue;
      const double d = set.beta.view().at(0, x, y) - (x < kEdgeColumn ? 0.65 : 0.35);
      sum += d * d;
      ++count;
    }
  return std::sqrt(sum / count);
}

TEST(Denoise, NoiseGoesAndAnEdgeThatTheSumDoesNotShowStays) {
  Capture capture = rotatedCapture(2);
  capture.noise = SensorNoise{.002, 4000};
  const SyntheticSet truth = hiddenEdge();
  const CapturePixels pixels = photograph(capture, truth);
  SolveOptions options;
  options.solver = "maximum-likelihood";
  const SolvedSet plain = solve(capture, pixels, options);
  options.denoise = Denoise::Guided;
  const SolvedSet smooth = solve(capture, pixels, options);
  const double jump = columnMean(smooth, kEdgeColumn - 1) - columnMean(smooth, kEdgeColumn);
  EXPECT_LT(flatError(smooth), 0.2 * flatError(plain));
  EXPECT_GT(jump, 0.29);
}

TEST(Denoise, TheSumOfTheLightsIsNotTouched) {
  Capture capture = rotatedCapture(3);
  capture.noise = SensorNoise{.005, 2000};
  const CapturePixels pixels = photograph(capture, SyntheticSet(3, 0.2F));
  SolveOptions options;
  const SolvedSet plain = solve(capture, pixels, options);
  options.denoise = Denoise::Guided;
  const SolvedSet smooth = solve(capture, pixels, options);
  const Image before = sumAtUnitWhite(plain);
  const Image after = sumAtUnitWhite(smooth);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < before.pixelCount(); ++p)
      ASSERT_NEAR(after.plane(c)[p], before.plane(c)[p], 1e-4F) << p;
  for (const Image& t : smooth.contributions)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < t.pixelCount(); ++p) ASSERT_GE(t.plane(c)[p], 0.0F);
}

}  // namespace
}  // namespace swaplight
