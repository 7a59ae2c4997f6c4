// Shadows that are softened, and where softening ends.
#include "core/edit/apply/soft_visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/edit/apply/shadow_silhouette.h"

namespace swaplight {
namespace {

constexpr int kWidth = 240, kHeight = 160;
constexpr int kOutline = 80;   // columns left of it are a thing that stands before a wall
constexpr int kCastEdge = 80;  // rows above it are in its shadow, on the wall
constexpr int kRadius = 16;

Image visibilityOf(bool cast) {
  Image seen(ImageSpec{kWidth, kHeight, {"Y"}, "data"}, 1.F);
  for (int y = 0; y < (cast ? kCastEdge : kHeight); ++y)
    for (int x = kOutline; x < kWidth; ++x) seen.span().at(0, x, y) = 0;
  return seen;
}

/// Two lights on it; the second is even, and shows what is painted. Noise of 1 %.
SolvedSet painted(float (*reflectance)(int x, int y)) {
  std::mt19937 random(1);
  std::normal_distribution<float> noise(1, .01F);
  const Image seen = visibilityOf(true);
  SolvedSet set;
  for (int i = 0; i < 2; ++i) {
    Image& light = set.contributions.emplace_back(ImageSpec::rgb(kWidth, kHeight));
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
          light.span().at(c, x, y) =
              reflectance(x, y) * (i == 0 ? seen.view().at(0, x, y) : 1) * noise(random);
  }
  return set;
}

float beforeAWall(int x, int) {
  return x < kOutline ? .2F : .6F;
}

Image noneOf(const Image& image) {
  return {image.spec(), 0.F};
}

TEST(SoftVisibility, SpreadsAnEdgeAsAGaussianOfHalfTheRadius) {
  const Image seen = visibilityOf(false);
  const Image soft = softVisibility(seen, noneOf(seen), kRadius);
  // Its slope's mean and standard deviation, along a row.
  double mean = 0, square = 0;
  for (int x = 1; x < kWidth; ++x) {
    const double slope = soft.view().at(0, x - 1, 80) - soft.view().at(0, x, 80);
    EXPECT_GE(slope, 0);
    mean += slope * x;
    square += slope * x * x;
  }
  EXPECT_NEAR(mean, kOutline, .2);
  EXPECT_NEAR(std::sqrt(square - mean * mean), kRadius / 2., .1 * kRadius / 2);
  EXPECT_NEAR(soft.view().at(0, kOutline, 10), soft.view().at(0, kOutline, 150), 1e-5);
}

TEST(SoftVisibility, StaysWithinWhatItIsMadeOf) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> any(0, 1);
  Image seen(ImageSpec{61, 47, {"Y"}, "data"});
  Image silhouettes(ImageSpec{30, 20, {"Y"}, "data"});
  std::generate_n(seen.plane(0), seen.pixelCount(), [&] { return any(random); });
  std::generate_n(silhouettes.plane(0), silhouettes.pixelCount(), [&] { return any(random); });
  for (const int radius : {1, 7, 500}) {
    const Image soft = softVisibility(seen, silhouettes, radius);
    const auto [least, most] = std::minmax_element(soft.plane(0), soft.plane(0) + soft.pixelCount());
    EXPECT_GE(*least, 0);
    EXPECT_LE(*most, 1);
  }
}

TEST(SoftVisibility, GoesOverNoSilhouette) {
  const Image seen = visibilityOf(false);
  Image silhouettes = noneOf(seen);
  for (int y = 0; y < kHeight; ++y) silhouettes.span().at(0, kOutline, y) = 1;
  const Image soft = softVisibility(seen, silhouettes, kRadius);
  for (int x = 0; x < kWidth; ++x) EXPECT_NEAR(soft.view().at(0, x, 80), seen.view().at(0, x, 80), 1e-5) << x;
}

TEST(ShadowSilhouettes, AreWhereTheOtherLightsShowAnEdgeToo) {
  const Image found = shadowSilhouettes(visibilityOf(true), painted(beforeAWall), 0);
  for (int y = 10; y < kCastEdge - 10; ++y) EXPECT_GT(found.view().at(0, kOutline, y), .9) << y;
  for (int y = kCastEdge + 10; y < kHeight; ++y) EXPECT_EQ(found.view().at(0, kOutline, y), 0) << y;
  for (int x = kOutline + 20; x < kWidth; ++x) EXPECT_EQ(found.view().at(0, x, kCastEdge), 0) << x;
}

TEST(ShadowSilhouettes, AreNoStripesUnderACastEdge) {
  const auto stripes = [](int x, int) { return x / 6 % 2 ? .2F : .7F; };
  const Image found = shadowSilhouettes(visibilityOf(true), painted(stripes), 0);
  const float* row = found.view().row(0, kCastEdge);
  EXPECT_EQ(*std::max_element(row + kOutline + 20, row + kWidth), 0);
}

TEST(ShadowSilhouettes, AreNotFoundInASetOfOneLight) {
  SolvedSet set = painted(beforeAWall);
  set.contributions.pop_back();
  const Image found = shadowSilhouettes(visibilityOf(true), set, 0);
  EXPECT_EQ(*std::max_element(found.plane(0), found.plane(0) + found.pixelCount()), 0);
}

TEST(ShadowSilhouettes, KeepTheRimOfAThingFromGlowing) {
  const Image seen = visibilityOf(true);
  const Image soft = softVisibility(seen, shadowSilhouettes(seen, painted(beforeAWall), 0), kRadius);
  // Far from the cast edge, on either side of the outline.
  EXPECT_LT(soft.view().at(0, kOutline + 2, 20), .01);
  EXPECT_GT(soft.view().at(0, kOutline - 3, 20), .99);
  // The cast edge is soft.
  EXPECT_NEAR(soft.view().at(0, 180, kCastEdge - 8), .16, .05);
  EXPECT_NEAR(soft.view().at(0, 180, kCastEdge + 8), .84, .05);
}

}  // namespace
}  // namespace swaplight
