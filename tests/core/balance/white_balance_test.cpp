#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "core/balance/illuminant.h"
#include "core/balance/neutral_rig.h"
#include "core/balance/set_balance.h"
#include "core/balance/two_color_balance.h"
#include "core/balance/white_point.h"
#include "core/base/error.h"
#include "core/color/chromaticity.h"
#include "core/ocio/luminance.h"
#include "core/relight/relight.h"
#include "core/relight/setting.h"
#include "tests/support/rgb_near.h"
#include "tests/support/small_set.h"

namespace swaplight {
namespace {

using test::expectNear;

constexpr float kNoClip = std::numeric_limits<float>::infinity();

Rgb pixelOf(const Image& image, size_t p) {
  return {image.plane(0)[p], image.plane(1)[p], image.plane(2)[p]};
}

TEST(WhitePoint, ThePublishedChromaticitiesComeOut) {
  // CIE 015:2018, table 11.
  const struct {
    const char* name;
    double x, y;
  } published[] = {
      {"A", .44758, .40745}, {"D50", .34567, .35851}, {"D55", .33243, .34744}, {"D65", .31272, .32903}};
  for (const auto& white : published) {
    const Chromaticity found = xyFromRec709(colorOfWhite(whitePointFromText(white.name)));
    EXPECT_NEAR(found.x, white.x, 3e-4) << white.name;
    EXPECT_NEAR(found.y, white.y, 3e-4) << white.name;
  }
}

TEST(WhitePoint, TextsAreReadBackAndWrongOnesAreQuoted) {
  for (const char* text : {"A", "D50", "D55", "D60", "D65", "4300K", "4300K,duv:+0.003", "D55,duv:-0.01"})
    EXPECT_EQ(textFromWhitePoint(whitePointFromText(text)), text);
  EXPECT_EQ(whitePointFromText("d65"), whitePointFromText("D65"));
  for (const char* text :
       {"", "E", "D99", "300K", "1e9K", "nanK", "4300", "D65,0.1", "D65,duv:0.2", "D65,duv:", "K"})
    EXPECT_THROW((void)whitePointFromText(text), InputError) << text;
}

TEST(WhitePoint, ALampOfThatWhiteHasItsColor) {
  for (const char* text : {"A", "D50", "D65", "4300K", "3200K,duv:+0.02", "3200K,duv:-0.045"}) {
    const WhitePoint white = whitePointFromText(text);
    expectNear(colorFactor(lightColorOfWhite(white)), colorOfWhite(white), 2e-3F);
    EXPECT_NEAR(luminance(colorOfWhite(white)), 1, 1e-5F);
  }
}

TEST(NeutralRig, ALightBecomesWhiteAndStaysAsBright) {
  SolvedSet set = test::smallSet(3, 8, 6);
  Rig rig = defaultRig(set.capture);
  applySetting(rig.lights[0], "rgb:0.9/0.2/0.15,+1st");
  applySetting(rig.lights[1], "#4060ff,x0.5");
  applySetting(rig.lights[2], "rgb:0/0/0");
  for (const char* white : {"D65", "A", "D50,duv:+0.01"}) {
    const Rig balanced = neutralized(rig, lightsFromText(rig, "all-but:light2"), whitePointFromText(white));
    EXPECT_NEAR(luminance(lightFactor(balanced.lights[0])), luminance(lightFactor(rig.lights[0])), 1e-4F);
    const Rgb color = lightFactor(balanced.lights[0]);
    expectNear(color / luminance(color), colorOfWhite(whitePointFromText(white)), 3e-3F);
    EXPECT_EQ(balanced.lights[1], rig.lights[1]);
    EXPECT_EQ(balanced.lights[2], rig.lights[2]) << "black has no colour to lose";
  }
  EXPECT_EQ(lightsFromText(rig, "all"), (std::vector<size_t>{0, 1, 2}));
  EXPECT_EQ(lightsFromText(rig, "light3,light1"), (std::vector<size_t>{0, 2}));
  EXPECT_THROW((void)lightsFromText(rig, "light9"), InputError);
}

/// Two coloured lamps, and both white at their own luminance.
struct Lit {
  SolvedSet set = test::smallSet(2, 120, 90);
  Rgb weights = kRec709Luminance;
  LampBalance balance{{{.70F, .23F, .13F}, {.10F, .25F, .88F}}, {}, 1};
  std::vector<size_t> all{0, 1};
  Lit() { balance.targets = whiteTargets(balance.lamps, all, Rgb(1), weights); }
};

TEST(SetBalance, WithoutNoiseThePhotographBecomesTheSetUnderWhiteLamps) {
  const Lit lit;
  const Image photograph = relight(lit.set, lit.balance.lamps);
  const Image truth = relight(lit.set, lit.balance.targets);
  const Image out = balanceBySet(lit.set, photograph, kNoClip, lit.balance, {1e-12F, 0, 0});
  for (size_t p = 0; p < out.pixelCount(); ++p) expectNear(pixelOf(out, p), pixelOf(truth, p), 2e-5F);
}

TEST(SetBalance, WhatIsNotInTheSetIsBalancedToo) {
  const Lit lit;
  Image photograph = relight(lit.set, lit.balance.lamps);
  Image truth = relight(lit.set, lit.balance.targets);
  const Rgb actor(.4F, 1.3F, 1.8F);  // someone of another reflectance stands there
  for (int y = 30; y < 60; ++y)
    for (int x = 40; x < 80; ++x)
      for (int c = 0; c < 3; ++c) {
        photograph.span().at(c, x, y) *= actor[c];
        truth.span().at(c, x, y) *= actor[c];
      }
  const Image out = balanceBySet(lit.set, photograph, kNoClip, lit.balance, {1e-10F, 0, 0});
  for (size_t p = 0; p < out.pixelCount(); ++p) expectNear(pixelOf(out, p), pixelOf(truth, p), 1e-3F);
}

TEST(SetBalance, NoiseIsNotDividedByALampsColor) {
  Lit lit;
  lit.balance.lamps[0].b = .005F;  // a gel that lets no blue pass
  lit.balance.targets = whiteTargets(lit.balance.lamps, lit.all, Rgb(1), lit.weights);
  Image photograph = relight(lit.set, lit.balance.lamps);
  std::mt19937 random(4);
  std::normal_distribution<float> normal(0, .004F);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < photograph.pixelCount(); ++p) photograph.plane(c)[p] += normal(random);
  const Image truth = relight(lit.set, lit.balance.targets);
  const Image out = balanceBySet(lit.set, photograph, kNoClip, lit.balance, {.004F * .004F, 0, 0});
  double squares = 0;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < out.pixelCount(); ++p) {
      ASSERT_TRUE(std::isfinite(out.plane(c)[p]));
      squares += std::pow(double(out.plane(c)[p] - truth.plane(c)[p]), 2);
    }
  EXPECT_LT(std::sqrt(squares / double(3 * out.pixelCount())), .004)
      << "no more noise than was in the photograph";
}

TEST(SetBalance, WhereThePhotographIsClippedOrBrokenTheSetSpeaks) {
  const Lit lit;
  Image photograph = relight(lit.set, lit.balance.lamps);
  const Image truth = relight(lit.set, lit.balance.targets);
  const float clip = .25F;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < photograph.pixelCount(); ++p)
      photograph.plane(c)[p] = std::min(clip, photograph.plane(c)[p]);
  photograph.plane(1)[500] = std::numeric_limits<float>::quiet_NaN();
  const Image out = balanceBySet(lit.set, photograph, clip, lit.balance, {1e-12F, 0, 0});
  for (size_t p = 0; p < out.pixelCount(); ++p) expectNear(pixelOf(out, p), pixelOf(truth, p), 2e-5F);
}

TEST(SetBalance, LampsThatAreNotChosenKeepTheirColor) {
  const Lit lit;
  const std::vector<size_t> first{0};
  const std::vector<Rgb> targets = whiteTargets(lit.balance.lamps, first, Rgb(1), lit.weights);
  EXPECT_EQ(targets[1], lit.balance.lamps[1]);
  EXPECT_NEAR(targets[0].r, glm::dot(lit.balance.lamps[0], lit.weights), 1e-6F);
}

TEST(TwoColorBalance, GreySurfacesAreExactWhateverTheirReflectance) {
  const Rgb one(.9F, .5F, .2F), two(.3F, .6F, 1.1F);
  Image photograph(ImageSpec::rgb(50, 4)), truth(ImageSpec::rgb(50, 4));
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 50; ++x)
      for (int c = 0; c < 3; ++c) {
        const float grey = .05F + .3F * float(y), t = float(x) / 49;
        photograph.span().at(c, x, y) = grey * (t * one[c] + (1 - t) * two[c]);
        truth.span().at(c, x, y) =
            grey * (t * glm::dot(one, kRec709Luminance) + (1 - t) * glm::dot(two, kRec709Luminance));
      }
  const TwoColorBalance out = balanceByTwoColors(photograph, one, two, Rgb(1), kRec709Luminance);
  for (size_t p = 0; p < truth.pixelCount(); ++p)
    expectNear(pixelOf(out.picture, p), pixelOf(truth, p), 1e-5F);
  EXPECT_NEAR(out.beta.plane(0)[0], 0, 1e-5F);
  EXPECT_NEAR(out.beta.plane(0)[49], 1, 1e-5F);
  EXPECT_FALSE(tellTwoLampsApart(one, 3.F * one));
  EXPECT_TRUE(tellTwoLampsApart(one, two));
}

TEST(TwoColorBalance, NothingFiniteBecomesInfinite) {
  Image photograph(ImageSpec::rgb(4, 1), 0.F);
  photograph.plane(0)[1] = std::numeric_limits<float>::infinity();
  photograph.plane(1)[2] = 1e30F;
  photograph.plane(2)[3] = -1;
  const TwoColorBalance out = balanceByTwoColors(photograph, {1, 0, 0}, {0, 0, 1}, Rgb(1), kRec709Luminance);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < 4; ++p) EXPECT_TRUE(std::isfinite(out.picture.plane(c)[p]));
}

/// Random grey surfaces under one light, with edges.
Image greyWorld(const Rgb& light) {
  Image image(ImageSpec::rgb(80, 60));
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(.05F, .9F);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x) {
      const float grey = uniform(random);
      for (int c = 0; c < 3; ++c) image.span().at(c, x, y) = grey * light[c];
    }
  return image;
}

TEST(Illuminant, EveryMethodFindsTheLightOfAGreyWorld) {
  const Rgb light(.9F, .6F, .3F);
  const Image picture = greyWorld(light);
  for (const BalanceMethod& method : balanceMethods()) {
    if (std::string(method.name) == "xphoto-learning") continue;  // learned on photographs, not on grey noise
    const Image out = balanceByMethod(picture, kNoClip, method.name, Rgb(1), kRec709Luminance);
    // A local average of noise is a little coloured nowhere: all channels have the same grey.
    for (size_t p = 0; p < out.pixelCount(); p += 7) {
      const Rgb y = pixelOf(out, p);
      EXPECT_NEAR(y.r, y.g, .03F * y.g + .002F) << method.name;
      EXPECT_NEAR(y.b, y.g, .03F * y.g + .002F) << method.name;
    }
  }
}

TEST(Illuminant, TheLearningOneAnswersFinitely) {
  const Image out =
      balanceByMethod(greyWorld({.9F, .6F, .3F}), kNoClip, "xphoto-learning", Rgb(1), kRec709Luminance);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < out.pixelCount(); ++p) ASSERT_TRUE(std::isfinite(out.plane(c)[p]));
}

TEST(Illuminant, ClippedPixelsDoNotCount) {
  Image picture = greyWorld({.9F, .6F, .3F});
  for (size_t p = 0; p < 1000; ++p)
    for (int c = 0; c < 3; ++c) picture.plane(c)[p] = 1;
  const Rgb light = estimateIlluminant(picture, 1, {0, std::numeric_limits<double>::infinity(), 0});
  expectNear(light / light.r, Rgb(1, .6F / .9F, .3F / .9F), 1e-5F);
  EXPECT_EQ(estimateIlluminant(Image(ImageSpec::rgb(4, 4), 1.F), 1, {}), Rgb(1));
}

TEST(Illuminant, AnUnknownMethodListsTheKnown) {
  try {
    (void)balanceByMethod(greyWorld(Rgb(1)), kNoClip, "magic", Rgb(1), kRec709Luminance);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("grey-world"), std::string::npos);
  }
}

}  // namespace
}  // namespace swaplight
