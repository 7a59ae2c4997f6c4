#include "core/ocio/tone_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

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
