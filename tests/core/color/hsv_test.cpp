#include "core/color/hsv.h"

#include <gtest/gtest.h>

#include <random>

#include "core/color/srgb.h"

namespace swaplight {
namespace {

TEST(Hsv, PrimariesLieAThirdOfATurnApart) {
  EXPECT_EQ(rgbFromHsv({0, 1, 1}), Rgb(1, 0, 0));
  EXPECT_NEAR(rgbFromHsv({1 / 3.0f, 1, 1}).y, 1, 1e-6);
  EXPECT_NEAR(rgbFromHsv({2 / 3.0f, 1, 1}).z, 1, 1e-6);
  EXPECT_EQ(rgbFromHsv({0.4f, 0, 0.7f}), Rgb(0.7f));
  EXPECT_EQ(hsvFromRgb(Rgb(0.2f)), Rgb(0, 0, 0.2f));
}

TEST(Hsv, ComesBack) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const Rgb rgb{unit(random), unit(random), unit(random)};
    const Rgb again = rgbFromHsv(hsvFromRgb(rgb));
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(again[c], rgb[c], 2e-6);
  }
}

TEST(Srgb, MatchesTheStandardsOwnNumbersAndComesBack) {
  EXPECT_NEAR(linearFromSrgb(0.5f), 0.21404f, 1e-5);
  EXPECT_NEAR(srgbFromLinear(0.18f), 0.46135f, 1e-5);
  for (float v = -0.5f; v < 2; v += 0.01f) EXPECT_NEAR(linearFromSrgb(srgbFromLinear(v)), v, 1e-5);
}

}  // namespace
}  // namespace swaplight
