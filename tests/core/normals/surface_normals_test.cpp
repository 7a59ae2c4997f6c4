#include "core/normals/surface_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/normals/relief.h"
#include "tests/support/placed_ball.h"

namespace swaplight::test {
namespace {

constexpr int kWidth = kBallWidth;
constexpr int kHeight = kBallHeight;

const std::vector<LampPlace> kFive = {
    {-60, 25, {}, {}}, {50, 15, {}, {}}, {0, 60, {}, {}}, {-20, -10, {}, {}}, {30, 45, {}, {}}};

SurfaceNormals normalsOf(const LitBall& lit) {
  return surfaceNormals(lit.set, lit.source(), lit.lamps);
}

/// Degrees, the mean over pixels that have a normal.
double meanError(const Image& normals) {
  double sum = 0;
  int count = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const cv::Vec3d found(normals.view().at(0, x, y), normals.view().at(1, x, y),
                            normals.view().at(2, x, y));
      if (cv::norm(found) < .5) continue;
      sum += std::acos(std::clamp(found.dot(ballNormal(x, y)), -1., 1.)) * 180 / std::numbers::pi;
      ++count;
    }
  return count > 0 ? sum / count : 180;
}

TEST(SurfaceNormals, AreExactUnderMeteredLampsWhateverIsPainted) {
  const auto places = metered(kFive, {0, 1, -1, 2, 0});
  const SurfaceNormals found = normalsOf(ballUnder(places, {1, 2, .5, 4, 1}));
  EXPECT_LT(meanError(found.normals), .1);
  EXPECT_LT(static_cast<double>(found.refused.count()), .15 * kWidth * kHeight);  // the rim of the ball
  EXPECT_EQ(found.refused.disagreed, 0U);
  EXPECT_FALSE(found.isContradictory());
  EXPECT_GT(static_cast<double>(found.checked), .7 * kWidth * kHeight);
}

TEST(SurfaceNormals, FindTheLampsLevelsByTheirBrightPixels) {
  EXPECT_LT(meanError(normalsOf(ballUnder(kFive, {1, 2, .5, 4, 1})).normals), 5);
}

TEST(SurfaceNormals, FollowTheFalloffOfALampWhoseDistanceIsTold) {
  auto near = metered(kFive, {0, 0, 0, 0, 0});
  for (LampPlace& place : near) place.distance = 2;
  LitBall lit = ballUnder(near, {1, 1, 1, 1, 1});
  EXPECT_LT(meanError(normalsOf(lit).normals), .1);
  for (PlacedLight& lamp : lit.lamps) lamp.place.distance = {};
  EXPECT_GT(meanError(normalsOf(lit).normals), 3);
}

TEST(SurfaceNormals, AreRefusedWhereOneLampMakesAHighlight) {
  const auto places = metered(kFive, {0, 0, 0, 0, 0});
  const auto highlight = [](size_t lamp, int x, int) { return lamp == 1 && x > 40 && x < 56 ? .5 : 0.; };
  const SurfaceNormals found = normalsOf(ballUnder(places, {1, 1, 1, 1, 1}, highlight));
  EXPECT_LT(meanError(found.normals), 4);
  EXPECT_GT(found.refused.disagreed, size_t{15 * kHeight / 4});
}

TEST(SurfaceNormals, AreRefusedWhereLightWasNotMeasured) {
  LitBall lit = ballUnder(kFive, {1, 1, 1, 1, 1});
  lit.set.quality = Image(ImageSpec{kWidth, kHeight, {"residual", "sigma", "flags", "model"}, "data"}, 0.F);
  std::fill_n(lit.set.quality.plane(kFlags), 10 * kWidth, static_cast<float>(kClipped));
  const SurfaceNormals found = normalsOf(lit);
  EXPECT_EQ(found.refused.flagged, size_t{10 * kWidth});
  EXPECT_EQ(found.normals.view().at(2, 48, 5), 0);
  EXPECT_GT(found.normals.view().at(2, 48, 48), .5);
}

TEST(SurfaceNormals, AreRefusedWhereFewerThanThreeLampsShine) {
  LitBall lit = ballUnder(kFive, {1, 1, 1, 1, 1});
  for (size_t lamp = 0; lamp < 3; ++lamp)
    std::fill_n(lit.shadows[lamp].labels.begin(), 10 * kWidth, ShadowLabel::Umbra);
  const SurfaceNormals found = normalsOf(lit);
  EXPECT_GE(found.refused.fewLamps, size_t{10 * kWidth});
  EXPECT_EQ(found.normals.view().at(2, 48, 5), 0);
}

TEST(SurfaceNormals, ALampInAShadowThatWasNotFoundIsLeftOut) {
  const auto places = metered(kFive, {0, 0, 0, 0, 0});
  LitBall lit = ballUnder(places, {1, 1, 1, 1, 1});
  for (int y = 30; y < 66; ++y)
    for (int x = 30; x < 66; ++x)
      for (int c = 0; c < 3; ++c) lit.set.contributions[1].span().at(c, x, y) *= .1F;
  const SurfaceNormals found = normalsOf(lit);
  EXPECT_LT(meanError(found.normals), 2);  // the places are refined by those pixels, too
  EXPECT_GT(found.normals.view().at(2, 48, 48), .5);
  EXPECT_GT(found.shadowed, size_t{30 * 30});
  EXPECT_FALSE(found.isContradictory());
}

TEST(SurfaceNormals, AreRefusedWhereLampsStandInOneLine) {
  const std::vector<LampPlace> row = {{-50, 0, {}, {}}, {0, 0, {}, {}}, {50, 0, {}, {}}};
  const SurfaceNormals found = normalsOf(ballUnder(row, {1, 1, 1}));
  EXPECT_EQ(found.refused.count(), size_t{kWidth * kHeight});
  EXPECT_GT(found.refused.alike, size_t{kWidth * kHeight / 2});
}

TEST(SurfaceNormals, AreRefusedWhereLampsContradictEachOther) {
  auto places = metered(kFive, {0, 0, 0, 0, 0});
  LitBall lit = ballUnder(places, {1, 1, 1, 1, 1});
  lit.lamps[0].place.azimuth = 60;
  lit.lamps[2].place.elevation = -60;
  const SurfaceNormals found = normalsOf(lit);
  EXPECT_GT(static_cast<double>(found.refused.disagreed + found.shadowed), .2 * kWidth * kHeight);
  EXPECT_TRUE(found.isContradictory());
}

TEST(SurfaceNormals, OfADarkSetAreAllRefused) {
  const SurfaceNormals found = normalsOf(ballUnder(kFive, {0, 0, 0, 0, 0}));
  EXPECT_EQ(found.refused.count(), size_t{kWidth * kHeight});
}

TEST(Relief, OfABallStandsOutOfItsWall) {
  Image normals(ImageSpec{kWidth, kHeight, {"normal.X", "normal.Y", "normal.Z"}, "data"});
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c) normals.span().at(c, x, y) = static_cast<float>(ballNormal(x, y)[c]);
  const Image depth = reliefOf(normals);
  const auto at = [&](int x, int y) { return depth.view().at(0, x, y); };
  const double inside = kBallRadius - std::sqrt(kBallRadius * kBallRadius - .25 * .25);
  EXPECT_NEAR(at(72, 48) - at(48, 48), inside, .02);
  EXPECT_NEAR(at(48, 24) - at(48, 48), inside, .02);
  EXPECT_NEAR(at(48, 72) - at(48, 48), inside, .02);
}

}  // namespace
}  // namespace swaplight::test
