#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/edit/pool/lamp_fit.h"
#include "core/edit/pool/lamp_gain.h"
#include "core/edit/pool/lamp_handle.h"
#include "core/edit/pool/light_pool.h"
#include "tests/support/lamp_set.h"

namespace swaplight {
namespace {

constexpr int kColumns = 64;
constexpr int kRows = 36;

template <typename Make>
auto grid(const Make& make) {
  std::vector<decltype(make(0., 0.))> pixels;
  for (int y = 0; y < kRows; ++y)
    for (int x = 0; x < kColumns; ++x)
      pixels.push_back(make((x + .5) / kColumns - .5, (.5 * kRows - (y + .5)) / kColumns));
  return pixels;
}

TEST(LampFit, FindsALampInFrontOfATexturedWall) {
  std::mt19937 random(3);
  std::normal_distribution<double> texture(0, .3);
  for (const test::LampPlace lamp : {test::LampPlace{.3, .2, .6}, test::LampPlace{-.5, .4, .5}}) {
    const auto pixels = grid([&](double x, double y) {
      return PoolPixel{x, y, 7 * test::wallLight(lamp, x, y) * std::exp(texture(random)), 1};
    });
    const LampModel found = fitLamp(pixels);
    EXPECT_NEAR(found.position[0], lamp.x, .1);
    EXPECT_NEAR(found.position[1], lamp.y, .1);
    EXPECT_NEAR(found.position[2], lamp.z, .12);
  }
}

TEST(LampFit, OfNothingIsTheLikelyLamp) {
  const LampModel found = fitLamp(grid([](double x, double y) { return PoolPixel{x, y, 0, 1}; }));
  EXPECT_EQ(found.position, LampModel().position);
}

TEST(LightCone, IsFoundAroundShadowsThatLieInIt) {
  const LightCone cone{.1, -.05, .3, .2, std::cos(.4), std::sin(.4), .2};
  const auto found = findCone(grid([&](double x, double y) {
    const bool shadow = std::hypot(x - .15, y + .1) < .06;
    return SeenPixel{x, y, shadow ? 0 : cone.at(x, y)};
  }));
  ASSERT_TRUE(found);
  double worst = 0;
  for (double angle = 0; angle < 6.28; angle += .1) {  // the same edge, whichever axis is called the first
    const double x = .3 * std::cos(angle);
    const double y = .2 * std::sin(angle);
    const double px = .1 + std::cos(.4) * x - std::sin(.4) * y;
    const double py = -.05 + std::sin(.4) * x + std::cos(.4) * y;
    worst = std::max(worst, std::abs(found->radius(px, py) - 1));
  }
  EXPECT_LT(worst, .08);
  EXPECT_NEAR(found->softness, .2, .1);
}

TEST(LightCone, IsNotSeenWhereThereIsNone) {
  EXPECT_FALSE(findCone(grid([](double x, double y) { return SeenPixel{x, y, 1}; })));
  EXPECT_FALSE(findCone(grid([](double x, double y) { return SeenPixel{x, y, 0}; })));
  // Shadows in stripes, from one border to the other.
  EXPECT_FALSE(findCone(grid([](double x, double y) {
    return SeenPixel{x, y, std::sin(40 * x) > 0 ? 1. : 0.};
  })));
  EXPECT_FALSE(findCone({}));
}

TEST(LightPool, FindsASpotsConeAndContinuesItsLightBeyond) {
  const int width = 320;
  const int height = 180;
  const test::LampPlace spot{0, 0, .8, .2};
  test::LampPlace bare = spot;
  bare.tangent = 0;
  const SolvedSet set = test::lampSet(width, height, spot);
  const LightPool pool = measurePool(set, 0);
  ASSERT_TRUE(pool.cone);
  EXPECT_NEAR(pool.cone->radiusA, .16, .02);
  EXPECT_NEAR(pool.cone->radiusB, .16, .02);
  EXPECT_LT(pool.bounce, .02);
  // The ratio to the other light, a little outside the cone.
  const double x = .22;
  const double truth = test::wallLight(bare, x, 0) / test::wallLight({1.2, .3, 1.5}, x, 0);
  const cv::Mat& ratio = pool.ratio[1];
  const int column = static_cast<int>((x + .5) * ratio.cols);
  EXPECT_NEAR(std::log(ratio.at<float>(ratio.rows / 2, column) / truth), 0, .25);
  EXPECT_FALSE(measurePool(set, 1).cone);
}

TEST(LampGain, SaysWhereItGuesses) {
  const int width = 320;
  const int height = 180;
  const LightPool pool = measurePool(test::lampSet(width, height, {0, 0, .8, .2}), 0);
  LampChange change;
  change.pan = 15;
  const LampGain gain(pool, change, width, height);
  const auto at = [&](double x) { return gain.guessAt(static_cast<int>((x + .5) * width), height / 2); };
  EXPECT_GT(at(.25), .95);  // never lit before
  EXPECT_EQ(at(.05), 0);    // lit before and after
  EXPECT_EQ(at(-.45), 0);   // dark before and after
}

TEST(LampGain, GivesWhatTheOthersLightBrightlyNoMoreThanTheLampGives) {
  const int width = 320;
  const int height = 180;
  SolvedSet set = test::lampSet(width, height, {0, 0, .8, .2});
  const int x = static_cast<int>(.75 * width), y = height / 2;  // beside the cone, close before the fill
  const float most = measurePool(set, 0).most[1];
  set.contributions[1].span().at(1, x, y) = 100 * most;
  LampChange change;
  change.pan = 15;
  const LampGain gain(measurePool(set, 0), change, width, height);
  float light[3], white[3], solved[3];
  for (int c = 0; c < 3; ++c) {
    light[c] = solved[c] = set.contributions[0].view().at(c, x, y);
    white[c] = solved[c] + set.contributions[1].view().at(c, x, y);
  }
  const float mask = 1;
  gain.changeRow(x, y, 1, &mask,
                 {{&light[0], &light[1], &light[2]},
                  {&white[0], &white[1], &white[2]},
                  {&solved[0], &solved[1], &solved[2]}});
  EXPECT_GT(light[1], .2F * most);
  EXPECT_LT(light[1], 1.2F * most);
}

TEST(LampHandle, TheLampFollowsTheMiddleOfItsLight) {
  for (const LampModel& lamp :
       {LampModel(), LampModel{{.4, .3, .6}, {-.1, .05, 0}, 1}, LampModel{{-.6, 0, .3}, {.1, .1, 0}, 0}})
    for (const PlanePoint wanted :
         {PlanePoint{.2, -.1}, PlanePoint{-.3, .2}, PlanePoint{lamp.aim[0], lamp.aim[1]}})
      for (const LampChange& change : {movedTo(lamp, wanted), turnedTo(lamp, wanted)}) {
        const PlanePoint middle = middleOf(lamp, change);
        EXPECT_NEAR(middle.x, wanted.x, 1e-5);
        EXPECT_NEAR(middle.y, wanted.y, 1e-5);
      }
  EXPECT_TRUE(turnedTo(LampModel(), {0, 0}).isNeutral());
}

TEST(LampHandle, StaysOnTheSideToWhichALampThatShinesPastTheSetPoints) {
  for (const float degrees : {89.F, 89.99F, 90.F, 127.F}) {
    LampChange away;
    away.pan = .6F * degrees;
    away.tilt = -.8F * degrees;
    const PlanePoint middle = middleOf(LampModel(), away);
    EXPECT_NEAR(middle.x, 12, .1) << degrees;
    EXPECT_NEAR(middle.y, -16, .1) << degrees;
  }
}

TEST(LampHandle, TheRingOfABeamGoesThroughTheHand) {
  const LampModel right{{.3, 0, .8}, {.2, .1, 0}, 1};
  for (const LampInHand& held : {LampInHand{LampModel(), .8}, LampInHand{right, .3}}) {
    for (const double spread : {.5, 1., 3.})
      EXPECT_NEAR(spreadThrough(held, ringHandle(held, spread)), spread, 1e-9);
    // Any place of the ring is as good.
    const double radius = held.width / 4;
    EXPECT_NEAR(spreadThrough(held, {held.lamp.aim[0], held.lamp.aim[1] - 2 * radius}), 2, 1e-9);
  }
  EXPECT_LT(ringHandle({right, .3}, 1).x, right.aim[0]) << "on the side of the picture's middle";
  EXPECT_TRUE(std::isfinite(spreadThrough({right, 0}, {0, 0}))) << "of a light that lights nothing";
}

TEST(LightPool, IsAsWideAsWhatTheLampLights) {
  const LightPool pool = measurePool(test::lampSet(320, 180, {0, 0, .8, .2}), 0);
  EXPECT_NEAR(pool.width, .32, .05);  // of a cone, 2 * .8 * .2
}

}  // namespace
}  // namespace swaplight
