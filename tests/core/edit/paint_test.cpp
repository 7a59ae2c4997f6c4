#include "core/edit/shapes/paint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/curve.h"
#include "core/base/error.h"

namespace swaplight {
namespace {

Stroke brush(float radius, float flow, float opacity) {
  Stroke stroke;
  stroke.radius = radius;
  stroke.flow = flow;
  stroke.opacity = opacity;
  return stroke;
}

TEST(Painting, AStrokeIsTheSameHoweverOftenTheMouseReports) {
  Painting coarse(400, 300);
  Stroke stroke = brush(20, .3f, 1);
  stroke.points = {{50, 50, 1}, {290, 230, 1}};
  coarse.begin(stroke);
  Painting fine(400, 300);
  stroke.points.clear();
  fine.begin(stroke);
  for (int i = 0; i <= 60; ++i) {
    const float t = static_cast<float>(i) / 60;
    fine.add({50 + 240 * t, 50 + 180 * t, 1});
  }
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x)
      ASSERT_NEAR(coarse.mask().at(x, y), fine.mask().at(x, y), 2e-3) << x << " " << y;
}

TEST(Painting, BuildsUpToItsOpacityAndNeverBeyond) {
  Painting painting(100, 100);
  float before = 0;
  for (int k = 0; k < 40; ++k) {
    Stroke stroke = brush(20, .2f, .6f);
    stroke.points = {{50, 50, 1}};
    painting.begin(stroke);
    const float now = painting.mask().at(50, 50);
    EXPECT_GE(now, before);
    EXPECT_LE(now, .6f + 1e-4f);
    before = now;
  }
  EXPECT_NEAR(before, .6f, 1e-3);
  // A weaker stroke over it takes nothing away.
  Stroke weak = brush(20, 1, .2f);
  weak.points = {{50, 50, 1}};
  painting.begin(weak);
  EXPECT_EQ(painting.mask().at(50, 50), before);
}

TEST(Painting, ErasingTakesAwayAndOldStatesStay) {
  Painting painting(600, 600);
  Stroke stroke = brush(40, 1, 1);
  stroke.points = {{250, 250, 1}, {270, 262, 1}};
  painting.begin(stroke);
  const Painting before = painting;
  stroke.erase = true;
  painting.begin(stroke);
  EXPECT_NEAR(painting.mask().at(255, 255), 0, 1e-3);
  EXPECT_NEAR(before.mask().at(255, 255), 1, 1e-3);
  EXPECT_EQ(before.strokes().size(), 1u);
  // Only the tiles that were touched take memory: columns 3 and 4, rows 3 and 4.
  EXPECT_EQ(before.mask().bytes(), 4 * kMaskTile * kMaskTile * sizeof(uint16_t));
}

TEST(Painting, ReportsWhatADabChanged) {
  Painting painting(400, 300);
  painting.begin(brush(10, 1, 1));
  const PixelRect changed = painting.add({100.5f, 50.5f, 1});
  for (const PixelRect& area : painting.mask().differences(MaskRaster(400, 300)))
    EXPECT_EQ(intersection(changed, area), area);
  EXPECT_LE(changed.width, 22);
  EXPECT_TRUE(painting.add({-500, -500, 1}).x >= 0);
}

TEST(Painting, BeyondThePictureIsFine) {
  Painting painting(50, 50);
  Stroke stroke = brush(30, 1, 1);
  stroke.points = {{-200, 20, 1}, {300, 20, 1}};
  painting.begin(stroke);
  EXPECT_NEAR(painting.mask().at(25, 20), 1, 1e-3);
}

TEST(Curve, PassesThroughItsPointsAndDoesNotOvershoot) {
  const auto table = curveTable({{0, 0}, {.25f, .7f}, {.5f, .7f}, {.75f, .1f}, {1, 1}}, 1001);
  EXPECT_FLOAT_EQ(table[0], 0);
  EXPECT_NEAR(table[250], .7f, 1e-6);
  EXPECT_NEAR(table[750], .1f, 1e-6);
  EXPECT_FLOAT_EQ(table[1000], 1);
  for (int i = 0; i < 250; ++i)
    EXPECT_LE(table[static_cast<size_t>(i)], table[static_cast<size_t>(i) + 1] + 1e-6f);
  for (int i = 250; i < 500; ++i) EXPECT_NEAR(table[static_cast<size_t>(i)], .7f, 1e-6);
  for (const float y : table) {
    EXPECT_GE(y, 0);
    EXPECT_LE(y, 1);
  }
}

TEST(Curve, IsALineThroughTwoPointsAndConstantBeyondThem) {
  const auto table = curveTable({{.2f, .4f}, {.6f, .8f}}, 11);
  const float expected[] = {.4f, .4f, .4f, .5f, .6f, .7f, .8f, .8f, .8f, .8f, .8f};
  for (size_t i = 0; i < 11; ++i) EXPECT_NEAR(table[i], expected[i], 1e-6);
  EXPECT_THROW((void)curveTable({}, 11), InputError);
  EXPECT_THROW((void)curveTable({{.5f, 0}, {.5f, 1}}, 11), InputError);
}

}  // namespace
}  // namespace swaplight
