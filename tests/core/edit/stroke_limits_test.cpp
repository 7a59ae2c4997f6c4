#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/edit/shapes/paint.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using ::testing::HasSubstr;

Stroke through(std::vector<StrokePoint> points) {
  Stroke stroke;
  stroke.radius = 4;
  stroke.flow = 1;
  stroke.points = std::move(points);
  return stroke;
}

std::string refusalOf(const char* points) {
  return test::inputError([&] { (void)strokeFromJson(Json{{"points", Json::parse(points)}}, "edits.json"); });
}

TEST(StrokeLimits, WhatLiesOutsideOfThePictureCostsNothing) {
  const auto begun = std::chrono::steady_clock::now();
  Painting painting(32, 24);
  std::vector<StrokePoint> zigzag;
  for (int i = 0; i < 2000; ++i) zigzag.push_back({i % 2 ? 1e6F : -1e6F, static_cast<float>(i % 24), 1});
  painting.begin(through(zigzag));
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(2));
  EXPECT_NEAR(painting.mask().at(16, 12), 1, 1e-3);
}

TEST(StrokeLimits, DabsThatArePassedOverKeepTheDistanceOfThoseInside) {
  // The same way, with and without a picture that shows its beginning.
  Painting all(400, 40), end(100, 40);
  all.begin(through({{0, 20, 1}, {400, 20, 1}}));
  end.begin(through({{-300, 20, 1}, {100, 20, 1}}));
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 100; ++x) ASSERT_NEAR(end.mask().at(x, y), all.mask().at(x + 300, y), 1e-4) << x;
}

TEST(StrokeLimits, ALongStrokeIsReadInProportionToItsLength) {
  std::vector<StrokePoint> points(200000, {10, 10, 1});
  const auto begun = std::chrono::steady_clock::now();
  Painting painting(32, 24);
  painting.begin(through(std::move(points)));
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(2));
  EXPECT_EQ(painting.strokes().front()->points.size(), 200000U);
}

TEST(StrokeLimits, AnOlderStateKeepsItsPointsWhileTheStrokeGrows) {
  Painting painting(32, 24);
  painting.begin(through({{1, 1, 1}}));
  const Painting before = painting;
  painting.add({9, 9, 1});
  EXPECT_EQ(before.strokes().front()->points.size(), 1U);
  EXPECT_EQ(painting.strokes().front()->points.size(), 2U);
}

TEST(StrokeLimits, CoordinatesThatNoPictureHasAreRefused) {
  EXPECT_THAT(refusalOf("[[0, 0], [1e9, 0]]"), HasSubstr("edits.json: a point has the number 1000000000"));
  EXPECT_THAT(refusalOf("[[0, -1e300]]"), HasSubstr("expected a number from -1000000 to 1000000"));
  EXPECT_THAT(refusalOf("[[0, 0, 7]]"), HasSubstr("expected a number from 0 to 1"));
  EXPECT_THAT(refusalOf("[[0, null]]"), HasSubstr("null"));
}

}  // namespace
}  // namespace swaplight
