#include "core/ocio/tone_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/color/rgb.h"
#include "core/color/srgb.h"
#include "core/ocio/color_config.h"

namespace swaplight {
namespace {

TEST(ToneCurve, KnownValuesOfThePapers) {
  EXPECT_NEAR(reinhardGlobal(1), 0.5, 1e-12);
  EXPECT_NEAR(reinhardGlobal(0.18), 0.152542, 1e-6);
  EXPECT_NEAR(reinhardExtended(1, 4), (1 + 1 / 16.0) / 2, 1e-12);
  EXPECT_NEAR(reinhardExtended(4, 4), 1, 1e-12);
  EXPECT_NEAR(hable(1), 0.357430 / 0.725130, 1e-5) << "f(2) / f(11.2)";
  EXPECT_NEAR(hable(11.2 / 2), 1, 1e-12);
  EXPECT_NEAR(logarithmic(64), 1, 1e-12);
  EXPECT_NEAR(logarithmic(0.18), std::log(1.72) / std::log(257.0), 1e-12);
}

TEST(ToneCurve, EachRisesFromBlackToWhiteAndIsSmoothAtBlack) {
  for (const ToneCurve& tone : toneCurves()) {
    EXPECT_NEAR(tone.curve(0), 0, 1e-12) << tone.name;
    double last = -1;
    for (int eighth = -128; eighth < 128; ++eighth) {
      const double stops = eighth / 8.0;
      const double shown = tone.curve(std::exp2(stops));
      EXPECT_GE(shown, last) << tone.name << " at " << stops;
      EXPECT_LE(shown, 1) << tone.name << " at " << stops;
      last = shown;
    }
    EXPECT_GT(last, 0.99) << tone.name;
    EXPECT_LE(tone.curve(std::numeric_limits<double>::infinity()), 1) << tone.name;
    constexpr double kLittle = 1e-5;
    EXPECT_NEAR(tone.curve(-kLittle), -tone.curve(kLittle), 1e-3 * tone.curve(kLittle)) << tone.name;
  }
}

TEST(ToneCurve, ParametersOutOfRangeAreRefused) {
  EXPECT_THROW((void)reinhardExtended(1, 0), std::invalid_argument);
  EXPECT_THROW((void)hable(1, -1), std::invalid_argument);
  EXPECT_THROW((void)logarithmic(1, 0.5), std::invalid_argument);
}

// E. Chow's sigmoid.py and AgXBasesRGB.py, worked out by hand of their formulas.
TEST(AgxCurve, KeepsMiddleGreyAndEndsWhereAgXDoes) {
  EXPECT_NEAR(agxCurve(0.18), 0.18, 1e-12);
  EXPECT_NEAR(agxCurve(0.18 * std::exp2(6.5)), 1, 1e-12);
  EXPECT_NEAR(agxCurve(0.18 * std::exp2(-10)), 0, 1e-12);
  EXPECT_NEAR(agxCurve(1), 0.555999065, 1e-8);
  EXPECT_NEAR(agxCurve(0.01), 0.00626240926, 1e-8);
  EXPECT_EQ(agxCurve(1e6), agxCurve(0.18 * std::exp2(6.5)));
  EXPECT_EQ(agxCurve(std::numeric_limits<double>::infinity()), agxCurve(1e6));
  EXPECT_EQ(agxCurve(0), 0);
  EXPECT_EQ(agxCurve(-1), 0);
}

TEST(AgxCurve, RisesAllTheWay) {
  double last = -1;
  for (int i = -99 * 8; i < 65 * 8; ++i) {
    const double shown = agxCurve(0.18 * std::exp2(i / 80.0));
    EXPECT_GT(shown, last) << i / 80.0 << " stops about middle grey";
    last = shown;
  }
}

/// What a view shows of a colour on an sRGB monitor, display-linear.
Rgb shownIn(const char* view, const Rgb& light) {
  static const ColorConfig config("");
  Image image(ImageSpec::rgb(1, 1));
  for (int c = 0; c < 3; ++c) image.plane(c)[0] = light[c];
  config.applyView(image.span(), "lin_rec709", {"sRGB", view});
  return {linearFromSrgb(image.plane(0)[0]), linearFromSrgb(image.plane(1)[0]),
          linearFromSrgb(image.plane(2)[0])};
}
Rgb shownInAgx(const Rgb& light) {
  return shownIn(kRolledOffView, light);
}

TEST(AgxView, GreysAreTheCurve) {
  for (const float light : {0.001F, 0.02F, 0.18F, 0.5F, 1.F, 4.F, 15.F})
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(shownInAgx(Rgb(light))[c], agxCurve(light), 2e-4) << light;
}

// From the generator's matrices and formulas by another program.
TEST(AgxView, KnownValuesOfColours) {
  const auto expectNear = [](const Rgb& light, const Rgb& expected) {
    const Rgb shown = shownInAgx(light);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown[c], expected[c], 1e-3) << light.r << ' ' << light.g;
  };
  expectNear({1, 0, 0}, {0.699F, 0.055F, 0.013F});
  expectNear({0, 4, 0}, {0.546F, 0.816F, 0.388F});
  expectNear({0.8F, 0.8F, 16}, {0.645F, 0.732F, 1});
  expectNear({0.18F, 0.02F, 0.02F}, {0.168F, 0.015F, 0.013F});
}

/// 0 grey, 1 without one of the primaries.
double saturationOf(const Rgb& color) {
  return 1 - std::min({color.r, color.g, color.b}) / std::max({color.r, color.g, color.b});
}

/// How far a shown colour lies beside the line from grey to the lamp's colour, as a saturation: a change of
/// hue counts by how much of a hue there is.
double besideHueOf(const Rgb& lamp, const Rgb& shown) {
  const auto hue = [](const Rgb& c) { return std::atan2(std::sqrt(3.F) * (c.g - c.b), 2 * c.r - c.g - c.b); };
  const double turned = std::abs(std::remainder(hue(shown) - hue(lamp), 2 * M_PI));
  return saturationOf(shown) * std::sin(std::min(turned, M_PI / 2));
}

TEST(AgxView, LampsGoToWhiteAsTheyGetBrighterWithoutABreakOfHue) {
  const Rgb orange{1, 0.3F, 0};
  double worstPlain = 0;
  for (const Rgb& lamp : {Rgb{1, 0, 0}, Rgb{0, 1, 0}, Rgb{0, 0, 1}, orange, Rgb{0.05F, 0.05F, 1},
                          Rgb{1, 0, 1}, Rgb{0, 1, 1}, Rgb{1, 1, 0}, Rgb{0.1F, 0.4F, 1}}) {
    double last = 2;
    for (int half = -6; half <= 24; ++half) {
      const Rgb light = lamp * std::exp2(static_cast<float>(half) / 2);
      const Rgb shown = shownInAgx(light);
      EXPECT_LE(saturationOf(shown), last + 1e-3) << half / 2.0 << " stops";
      last = saturationOf(shown);
      EXPECT_LT(besideHueOf(lamp, shown), 0.25)
          << lamp.r << ' ' << lamp.g << ' ' << lamp.b << " at " << half / 2.0;
      if (lamp.g == orange.g) worstPlain = std::max(worstPlain, besideHueOf(lamp, shownIn("sRGB", light)));
    }
    EXPECT_LT(last, 0.05) << "12 stops above full scale";
  }
  EXPECT_GT(worstPlain, 0.6) << "cut off, orange turns to yellow";
}

TEST(ToneCurve, TheViewIsTheCurveThenTheDisplaysEncoding) {
  const ColorConfig config("");
  for (const ToneCurve& tone : toneCurves()) {
    Image image(ImageSpec::rgb(200, 1));
    for (int c = 0; c < 3; ++c)
      for (int x = 0; x < 200; ++x) image.plane(c)[x] = std::exp2(static_cast<float>(x - 140) / 10);
    const Image in = image.clone();
    config.applyView(image.span(), "lin_rec709", {"sRGB", tone.name});
    for (int x = 0; x < 200; ++x)
      ASSERT_NEAR(image.plane(1)[x], srgbFromLinear(static_cast<float>(tone.curve(in.plane(1)[x]))), 1e-4)
          << tone.name << " " << in.plane(1)[x];
  }
}

}  // namespace
}  // namespace swaplight
