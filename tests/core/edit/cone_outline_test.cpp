#include "core/edit/pool/cone_outline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/edit/pool/light_cone.h"

namespace swaplight {
namespace {

constexpr int kColumns = 160, kRows = 90;

template <typename Seen>
cv::Mat picture(const Seen& seen) {
  cv::Mat made(kRows, kColumns, CV_32F);
  for (int y = 0; y < kRows; ++y)
    for (int x = 0; x < kColumns; ++x)
      made.at<float>(y, x) = seen((x + .5) / kColumns - .5, (.5 * kRows - (y + .5)) / kColumns) ? 1.F : 0.F;
  return made;
}

/// A cone on a wall, and lower down on the floor before it, where it lies broader.
bool onWallAndFloor(double x, double y) {
  const double width = y > 0 ? .15 * std::sqrt(std::max(0., 1 - y * y / .04)) : .15 - .6 * y;
  return y > -.15 && std::abs(x) < width;
}

TEST(ConeOutline, FollowsAConeOverTheWallAndTheFloor) {
  const auto outline = ConeOutline::in(picture(onWallAndFloor));
  ASSERT_TRUE(outline);
  EXPECT_FALSE(outline->isCut());
  EXPECT_NEAR(outline->radius(.15, 0), 1, .05);
  EXPECT_NEAR(outline->radius(0, .2), 1, .06);
  EXPECT_NEAR(outline->radius(.21, -.1), 1, .05);
  EXPECT_LT(outline->radius(outline->middle().x, outline->middle().y), .15);
  EXPECT_GT(outline->radius(.3, .1), 1.5);
}

TEST(ConeOutline, IsNotBittenByShadowsOrWhatIsLitBesides) {
  const auto whole = ConeOutline::in(picture(onWallAndFloor));
  const auto bitten = ConeOutline::in(picture([](double x, double y) {
    const bool pole = std::abs(x - .04) < .02 && y < .1;  // from the lower edge up
    const bool gleam = std::hypot(x - .4, y - .1) < .03;
    return (onWallAndFloor(x, y) && !pole) || gleam;
  }));
  ASSERT_TRUE(whole && bitten);
  for (double x = -.45; x < .46; x += .09)
    for (double y = -.25; y < .26; y += .05)
      EXPECT_NEAR(bitten->radius(x, y), whole->radius(x, y), .12) << x << ' ' << y;
}

TEST(ConeOutline, GoesOnBeyondThePicture) {
  const auto outline = ConeOutline::in(picture([](double x, double) { return x > .3; }));
  ASSERT_TRUE(outline);
  EXPECT_TRUE(outline->isCut());
  EXPECT_NEAR(outline->radius(.3, 0), 1, .05);
  EXPECT_LT(outline->radius(.7, .5), .5) << "no edge at the picture's border";
}

TEST(ConeOutline, IsNoneWhereNothingEnds) {
  EXPECT_FALSE(ConeOutline::in(picture([](double, double) { return true; })));
  EXPECT_FALSE(ConeOutline::in(picture([](double, double) { return false; })));
  EXPECT_FALSE(ConeOutline::in(picture([](double x, double y) { return std::hypot(x, y) < .005; })));
}

TEST(ConeOutline, CanBeSetToAnotherRadius) {
  LightCone cone;
  cone.outline = ConeOutline::in(picture([](double x, double y) { return std::hypot(x, y) < .2; }));
  ASSERT_TRUE(cone.outline);
  EXPECT_NEAR(cone.meanRadius(), .2, .01);
  cone.setEdge(.8);
  EXPECT_NEAR(cone.radius(.16, 0), 1, .05);
  EXPECT_NEAR(cone.meanRadius(), .16, .01);
}

}  // namespace
}  // namespace swaplight
