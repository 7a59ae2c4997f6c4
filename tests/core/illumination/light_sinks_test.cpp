#include "core/illumination/light_sinks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/illumination/illumination.h"
#include "core/illumination/peaks.h"
#include "tests/support/lamp_set.h"

namespace swaplight::test {
namespace {

constexpr int kMapWidth = 256;
constexpr int kMapHeight = 144;

Image mapOf(const std::function<double(int, int)>& light) {
  Image map(ImageSpec{kMapWidth, kMapHeight, {"Y"}, "lin_rec709"});
  for (int y = 0; y < kMapHeight; ++y)
    for (int x = 0; x < kMapWidth; ++x) map.span().at(0, x, y) = static_cast<float>(light(x, y));
  return map;
}

/// A pool whose logarithm is a Gaussian.
double pool(int x, int y, double atX, double atY, double radius, double stops) {
  const double square = (x + .5 - atX) * (x + .5 - atX) + (y + .5 - atY) * (y + .5 - atY);
  return stops * std::exp(-.5 * square / (radius * radius));
}

TEST(LightSinks, APoolIsFoundWithItsBreadthAndStrength) {
  const auto sinks = findSinks(mapOf([](int x, int y) { return std::exp2(pool(x, y, 101.3, 70.2, 26, 3)); }));
  ASSERT_EQ(sinks.size(), 1U);
  EXPECT_NEAR(sinks[0].x, 101.3, .5);
  EXPECT_NEAR(sinks[0].y, 70.2, .5);
  EXPECT_GT(sinks[0].radius, 26 / 1.4);
  EXPECT_LT(sinks[0].radius, 26 * 1.4);
  EXPECT_NEAR(sinks[0].stops, 3, .5);
  EXPECT_GT(sinks[0].sigmas, 50);
  EXPECT_FALSE(sinks[0].outside);
}

/// The small picture in which pools are sought has 1000 x 333 at 256 x 85, not 85.2.
TEST(LightSinks, OfAPictureOfAnySidesLieInIt) {
  Image map(ImageSpec{1000, 333, {"Y"}, "lin_rec709"});
  for (int y = 0; y < 333; ++y)
    for (int x = 0; x < 1000; ++x)
      map.span().at(0, x, y) = static_cast<float>(std::exp2(pool(x, y, 500, 333, 90, 3)));
  const auto sinks = findSinks(map);
  ASSERT_EQ(sinks.size(), 1U);
  EXPECT_LE(sinks[0].y, 333);
  EXPECT_GT(sinks[0].y, 325);
}

TEST(LightSinks, TwoLampsMakeTwo) {
  const auto sinks = findSinks(mapOf([](int x, int y) {
    return std::exp2(pool(x, y, 45, 80, 26, 6)) + std::exp2(pool(x, y, 215, 60, 26, 5.8));
  }));
  ASSERT_EQ(sinks.size(), 2U);
  EXPECT_NEAR(sinks[0].x, 45, 2);
  EXPECT_NEAR(sinks[1].x, 215, 2);
  EXPECT_GT(sinks[0].prominence, sinks[1].prominence);
}

TEST(LightSinks, TextureAndNoiseMakeNone) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, .4);
  const auto sinks = findSinks(mapOf([&](int x, int y) {
    const double tiles = (x / 5 + y / 5) % 2 == 0 ? 1 : .7;
    return tiles * std::exp2(pool(x, y, 128, 70, 40, 3)) * std::exp(noise(random));
  }));
  ASSERT_EQ(sinks.size(), 1U);
  EXPECT_NEAR(sinks[0].x, 128, 8);
  EXPECT_NEAR(sinks[0].y, 70, 8);
}

TEST(LightSinks, AnArrowPointsAtALampOutOfFrame) {
  const LampPlace lamp{.75, .1, .3};  // widths of the picture from its middle; the border is at .5
  const auto sinks = findSinks(mapOf([&](int x, int y) {
    return wallLight(lamp, (x + .5) / kMapWidth - .5, (.5 * kMapHeight - y - .5) / kMapWidth);
  }));
  ASSERT_EQ(sinks.size(), 1U);
  ASSERT_TRUE(sinks[0].outside);
  EXPECT_GT(sinks[0].x, kMapWidth - 4);
  EXPECT_GT(sinks[0].outside->x, .9);
  EXPECT_NEAR(std::hypot(sinks[0].outside->x, sinks[0].outside->y), 1, 1e-9);
}

TEST(LightSinks, OfALampAtAWallLieWhereTheLampStands) {
  const SolvedSet set = lampSet(kMapWidth, kMapHeight, {-.15, .08, .3});
  const auto sinks = findSinks(illuminationMaps(set)[0]);
  ASSERT_EQ(sinks.size(), 1U);
  EXPECT_NEAR(sinks[0].x / kMapWidth - .5, -.15, .03);
  EXPECT_NEAR((.5 * kMapHeight - sinks[0].y) / kMapWidth, .08, .03);
}

TEST(LightSinks, DarkAndEvenMapsHaveNone) {
  EXPECT_TRUE(findSinks(mapOf([](int, int) { return 0; })).empty());
  EXPECT_TRUE(findSinks(mapOf([](int, int) { return .3; })).empty());
  Image tiny(ImageSpec{1, 1, {"Y"}, "lin_rec709"}, 1);
  EXPECT_TRUE(findSinks(tiny).empty());
}

TEST(Peaks, AreAsProminentAsTheWayDownFromThem) {
  const cv::Mat picture = (cv::Mat_<float>(1, 7) << 1, 5, 2, 4, 3, 9, 0);
  const std::vector<Peak> peaks = peaksOf(picture);
  ASSERT_EQ(peaks.size(), 3U);
  EXPECT_EQ(peaks[0].x, 5);
  EXPECT_EQ(peaks[0].prominence, 9);
  EXPECT_EQ(peaks[1].x, 1);
  EXPECT_EQ(peaks[1].prominence, 3);
  EXPECT_EQ(peaks[2].x, 3);
  EXPECT_EQ(peaks[2].prominence, 1);
}

TEST(Peaks, OfAPlainAreOne) {
  EXPECT_EQ(peaksOf(cv::Mat::ones(5, 6, CV_32F)).size(), 1U);
}

}  // namespace
}  // namespace swaplight::test
