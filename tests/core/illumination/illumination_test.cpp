#include "core/illumination/illumination.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <utility>

#include "core/base/error.h"
#include "tests/support/lamp_set.h"
#include "tests/support/small_set.h"

namespace swaplight::test {
namespace {

constexpr int kWidth = 192;
constexpr int kHeight = 108;
const LampPlace kKey{-.2, .1, .6};

using Picture = std::function<double(int x, int y, int c)>;

void multiply(SolvedSet& set, size_t light, const Picture& by) {
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < set.height(); ++y)
      for (int x = 0; x < set.width(); ++x)
        set.contributions[light].span().at(c, x, y) *= static_cast<float>(by(x, y, c));
  updateBeta(set);
}

void paint(SolvedSet& set, const Picture& reflectance) {
  for (size_t k = 0; k < set.contributions.size(); ++k) multiply(set, k, reflectance);
}

double checks(int x, int y, int c) {
  return (x / 9 + y / 9) % 2 == 0 ? 1 : std::array{.25, .4, .7}[static_cast<size_t>(c)];
}

// The logarithm's standard deviation about its mean: what is wrong beyond a constant.
double spread(const Image& map, const std::function<double(int, int)>& truth) {
  double sum = 0;
  double squares = 0;
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) {
      const double error = std::log(map.view().at(0, x, y) / truth(x, y));
      sum += error;
      squares += error * error;
    }
  const auto count = static_cast<double>(map.pixelCount());
  return std::sqrt(squares / count - sum / count * sum / count);
}

double keyLight(int x, int y) {
  return wallLight(kKey, (x + .5) / kWidth - .5, (.5 * kHeight - (y + .5)) / kWidth);
}

double spreadOver(const Image& map, const Image& other) {
  return spread(map, [&](int x, int y) { return double{other.view().at(0, x, y)}; });
}

Image mapOf(const SolvedSet& set, size_t light, const IlluminationOptions& options = {}) {
  return std::move(illuminationMaps(set, options)[light]);
}

// A wall of one grey, lit by the key and evenly by the fill.
SolvedSet greyWall() {
  SolvedSet set = lampSet(kWidth, kHeight, kKey);
  for (size_t k = 0; k < 2; ++k)
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
          set.contributions[k].span().at(c, x, y) = static_cast<float>(k == 0 ? .4 * keyLight(x, y) : .1);
  updateBeta(set);
  return set;
}

bool finite(const std::vector<Image>& maps) {
  for (const Image& map : maps)
    for (size_t p = 0; p < map.pixelCount(); ++p)
      if (!std::isfinite(map.plane(0)[p]) || map.plane(0)[p] < 0) return false;
  return true;
}

TEST(Illumination, IsTheLampsLightOnAWallOfTiles) {
  const SolvedSet set = lampSet(kWidth, kHeight, kKey);
  const Image map = mapOf(set, 0);
  Image grey(map.spec());
  for (size_t p = 0; p < grey.pixelCount(); ++p)
    grey.plane(0)[p] = (set.contributions[0].plane(0)[p] + set.contributions[0].plane(1)[p] +
                        set.contributions[0].plane(2)[p]) /
                       3;
  const double bias = spread(mapOf(greyWall(), 0), keyLight);  // a pool is not straight within the window
  EXPECT_LT(spread(map, keyLight), std::hypot(bias, .3 * spread(grey, keyLight)))
      << "what is left of the tiles";
}

TEST(Illumination, AnotherReflectanceOfTheSetLeavesIt) {
  SolvedSet set = lampSet(kWidth, kHeight, kKey);
  const std::vector<Image> before = illuminationMaps(set);
  paint(set, checks);
  const std::vector<Image> after = illuminationMaps(set);
  for (size_t k = 0; k < before.size(); ++k) {
    EXPECT_LT(spreadOver(after[k], before[k]), .05) << "of light " << k << "; the checks' own is above .4";
    const double other = after[k].plane(0)[0] / before[k].plane(0)[0];
    EXPECT_GT(other, .3) << "a darker set is lit as darker grey";
    EXPECT_LT(other, 1);
  }
}

TEST(Illumination, ColourTellsTextureFromLight) {
  const auto light = [](int x, int y) { return (x / 24 + y / 24) % 2 == 0; };
  SolvedSet coloured = greyWall();
  paint(coloured, [&](int x, int y, int c) {
    return light(x, y) ? 1 : std::array{.2, .3, .9}[static_cast<size_t>(c)];
  });
  SolvedSet grey = greyWall();
  paint(grey, [&](int x, int y, int) { return light(x, y) ? 1 : .4667; });
  const Image truth = mapOf(greyWall(), 0);
  EXPECT_LT(spreadOver(mapOf(coloured, 0), truth), .6 * spreadOver(mapOf(grey, 0), truth));
}

TEST(Illumination, KeepsTheEdgeOfAShadow) {
  SolvedSet set = lampSet(kWidth, kHeight, kKey);
  const auto inShadow = [](int x, int y) { return std::hypot(x - 120, y - 50) < 20; };
  multiply(set, 0, [&](int x, int y, int) { return inShadow(x, y) ? .1 : 1; });
  paint(set, checks);
  const Image map = mapOf(set, 0);
  const auto at = [&](int x, int y) { return map.view().at(0, x, y) / keyLight(x, y); };
  EXPECT_NEAR(at(120, 50) / at(85, 50), .1, .05);
  EXPECT_NEAR(at(104, 50) / at(96, 50), .1, .08) << "four pixels to each side of the edge";
  const Image other = mapOf(set, 1);
  EXPECT_NEAR(other.view().at(0, 104, 50) / other.view().at(0, 96, 50), 1, .2) << "which is the key's alone";
}

TEST(Illumination, SmoothingTakesReliefAway) {
  const double without = spread(mapOf(lampSet(kWidth, kHeight, kKey), 0), keyLight);
  SolvedSet set = lampSet(kWidth, kHeight, kKey);
  multiply(set, 0, [](int x, int, int) { return 1 + .2 * std::sin(x * .9); });
  EXPECT_GT(spread(mapOf(set, 0, {0}), keyLight), 1.3 * without);
  EXPECT_LT(spread(mapOf(set, 0), keyLight), 1.05 * without);
}

TEST(Illumination, OfAGreySetIsTheSetItself) {
  const SolvedSet set = greyWall();
  const SolvedSet grey = greySet(set);
  for (size_t k = 0; k < 2; ++k) {
    const double level = meanError(set.contributions[k], Image(set.contributions[k].spec(), 0));
    EXPECT_LT(meanError(grey.contributions[k], set.contributions[k]), .07 * level) << "of light " << k;
  }
  EXPECT_EQ(grey.capture.lights[1].name, "fill");
  EXPECT_EQ(grey.beta.spec(), set.beta.spec());
}

TEST(Illumination, IsFiniteWhereThereIsNoLight) {
  SolvedSet dark = lampSet(40, 30, kKey);
  paint(dark, [](int, int, int) { return 0.; });
  EXPECT_TRUE(finite(illuminationMaps(dark)));
  SolvedSet half = lampSet(40, 30, kKey);
  paint(half, [](int x, int, int) { return x < 20 ? 0. : 1e4; });
  multiply(half, 1, [](int, int, int) { return 0.; });
  EXPECT_TRUE(finite(illuminationMaps(half)));
  EXPECT_TRUE(finite(illuminationMaps(smallSet(6, 37, 3))));
  EXPECT_TRUE(finite(illuminationMaps(smallSet(1, 1, 1))));
  EXPECT_TRUE(finite(illuminationMaps(smallSet(1, 64, 48), {.25})));
}

TEST(Illumination, HardlyChangesForAPixelWithLessThanNoLight) {
  SolvedSet set = lampSet(kWidth, kHeight, kKey);
  const std::vector<Image> before = illuminationMaps(set);
  for (Image& contribution : set.contributions)
    for (int c = 0; c < 3; ++c) contribution.span().at(c, 40, 30) = -.2F;
  const std::vector<Image> after = illuminationMaps(set);
  EXPECT_TRUE(finite(after));
  for (size_t k = 0; k < before.size(); ++k)
    for (const auto& [x, y] : {std::pair{5, 5}, {100, 50}, {180, 100}})
      EXPECT_NEAR(after[k].view().at(0, x, y), before[k].view().at(0, x, y),
                  .03 * before[k].view().at(0, x, y));
}

TEST(Illumination, IsTheSameAtAnySize) {
  const Image small = mapOf(lampSet(kWidth, kHeight, kKey), 0);
  const Image large = mapOf(lampSet(2 * kWidth, 2 * kHeight, kKey), 0);
  double worst = 0;
  for (int y = 4; y < kHeight; y += 8)
    for (int x = 4; x < kWidth; x += 8)
      worst = std::max(worst,
                       std::abs(std::log(large.view().at(0, 2 * x, 2 * y) / small.view().at(0, x, y)) * 1.));
  EXPECT_LT(worst, .35) << "tiles are half as large there";
}

TEST(Illumination, CanBeStopped) {
  const std::atomic<bool> stop = true;
  EXPECT_THROW((void)illuminationMaps(lampSet(40, 30, kKey), {}, {{}, &stop}), Stopped);
}

}  // namespace
}  // namespace swaplight::test
