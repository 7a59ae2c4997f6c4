#include "core/normals/surface_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/normals/relief.h"

namespace swaplight::test {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 96;
constexpr double kRadius = 0.45;  // of the ball, widths of the picture

const std::vector<LampPlace> kFive = {
    {-60, 25, {}, {}}, {50, 15, {}, {}}, {0, 60, {}, {}}, {-20, -10, {}, {}}, {30, 45, {}, {}}};

double columnPlace(int x) {
  return (x + .5) / kWidth - .5;
}
double rowPlace(int y) {
  return (.5 * kHeight - y - .5) / kWidth;
}

/// Of a ball before a wall; it goes as deep as the wall in its middle.
cv::Vec3d ballNormal(int x, int y) {
  const double px = columnPlace(x);
  const double py = rowPlace(y);
  const double square = kRadius * kRadius - px * px - py * py;
  if (square <= 0) return {0, 0, 1};
  return cv::Vec3d(px, py, std::sqrt(square)) / kRadius;
}

/// What a lamp sends to each pixel; the shadows are those of surfaces turned away.
struct Lit {
  SolvedSet set;
  std::vector<LightShadows> shadows;
  std::vector<PlacedLight> lamps;
};

using Added = std::function<double(size_t lamp, int x, int y)>;

/// `levels`: of each lamp. `added`: light that no matte surface gives.
Lit ballUnder(
    const std::vector<LampPlace>& places, const std::vector<double>& levels,
    const Added& added = [](size_t, int, int) { return 0.; }) {
  Lit lit;
  for (size_t i = 0; i < places.size(); ++i) {
    lit.set.capture.lights.push_back({"lamp" + std::to_string(i), Role::Other, {}});
    Image& light = lit.set.contributions.emplace_back(ImageSpec::rgb(kWidth, kHeight));
    LightShadows& shadows = lit.shadows.emplace_back();
    shadows.labels.resize(light.pixelCount(), ShadowLabel::Umbra);
    const LampRays rays(places[i]);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const LampRay ray = rays.at(columnPlace(x), rowPlace(y));
        const double facing = ballNormal(x, y).dot(ray.direction);
        const double tile = .3 + .4 * ((x / 7 + y / 5) % 2);  // two paints
        const double value = levels[i] * ray.level * tile * std::max(facing, 0.) + added(i, x, y);
        for (int c = 0; c < 3; ++c) light.span().at(c, x, y) = static_cast<float>(value);
        if (facing > .05)
          shadows.labels[static_cast<size_t>(y) * kWidth + static_cast<size_t>(x)] = ShadowLabel::Lit;
      }
    lit.lamps.push_back({i, places[i]});
  }
  lit.set.beta = Image(ImageSpec{kWidth, kHeight, {}, "data"});
  return lit;
}

SurfaceNormals normalsOf(const Lit& lit) {
  return surfaceNormals(lit.set, lit.shadows, lit.lamps);
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

std::vector<LampPlace> metered(std::vector<LampPlace> places, const std::vector<double>& stops) {
  for (size_t i = 0; i < places.size(); ++i) places[i].stops = stops[i];
  return places;
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
  Lit lit = ballUnder(near, {1, 1, 1, 1, 1});
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
  Lit lit = ballUnder(kFive, {1, 1, 1, 1, 1});
  lit.set.quality = Image(ImageSpec{kWidth, kHeight, {"residual", "sigma", "flags", "model"}, "data"}, 0.F);
  std::fill_n(lit.set.quality.plane(kFlags), 10 * kWidth, static_cast<float>(kClipped));
  const SurfaceNormals found = normalsOf(lit);
  EXPECT_EQ(found.refused.flagged, size_t{10 * kWidth});
  EXPECT_EQ(found.normals.view().at(2, 48, 5), 0);
  EXPECT_GT(found.normals.view().at(2, 48, 48), .5);
}

TEST(SurfaceNormals, AreRefusedWhereFewerThanThreeLampsShine) {
  Lit lit = ballUnder(kFive, {1, 1, 1, 1, 1});
  for (size_t lamp = 0; lamp < 3; ++lamp)
    std::fill_n(lit.shadows[lamp].labels.begin(), 10 * kWidth, ShadowLabel::Umbra);
  const SurfaceNormals found = normalsOf(lit);
  EXPECT_GE(found.refused.fewLamps, size_t{10 * kWidth});
  EXPECT_EQ(found.normals.view().at(2, 48, 5), 0);
}

TEST(SurfaceNormals, AreRefusedWhereLampsStandInOneLine) {
  const std::vector<LampPlace> row = {{-50, 0, {}, {}}, {0, 0, {}, {}}, {50, 0, {}, {}}};
  const SurfaceNormals found = normalsOf(ballUnder(row, {1, 1, 1}));
  EXPECT_EQ(found.refused.count(), size_t{kWidth * kHeight});
  EXPECT_GT(found.refused.alike, size_t{kWidth * kHeight / 2});
}

TEST(SurfaceNormals, AreRefusedWhereLampsContradictEachOther) {
  auto places = metered(kFive, {0, 0, 0, 0, 0});
  Lit lit = ballUnder(places, {1, 1, 1, 1, 1});
  lit.lamps[0].place.azimuth = 60;
  lit.lamps[2].place.elevation = -60;
  const SurfaceNormals found = normalsOf(lit);
  EXPECT_GT(static_cast<double>(found.refused.disagreed), .2 * kWidth * kHeight);
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
  const double inside = kRadius - std::sqrt(kRadius * kRadius - .25 * .25);
  EXPECT_NEAR(at(72, 48) - at(48, 48), inside, .02);
  EXPECT_NEAR(at(48, 24) - at(48, 48), inside, .02);
  EXPECT_NEAR(at(48, 72) - at(48, 48), inside, .02);
}

}  // namespace
}  // namespace swaplight::test
