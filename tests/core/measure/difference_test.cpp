#include "core/measure/difference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/measure/difference_picture.h"

namespace swaplight {
namespace {

Image grey(int width, int height, float value) {
  return Image(ImageSpec::rgb(width, height), value);
}

PicturePair pairOf(Image test, Image reference, bool encoded = false, float scale = 1) {
  return {std::move(test), std::move(reference), encoded, scale};
}

TEST(Difference, OfEqualPicturesIsNothing) {
  const PicturePair pair = pairOf(grey(8, 5, .3f), grey(8, 5, .3f));
  EXPECT_EQ(difference(pair, Metric::DeltaE2000).value, 0);
  EXPECT_EQ(difference(pair, Metric::AbsDiff).value, 0);
  EXPECT_EQ(difference(pair, Metric::Rmse).value, 0);
  EXPECT_EQ(difference(pair, Metric::Psnr).value, kLargestPsnr);
}

TEST(Difference, OfAConstantStepIsThatStep) {
  PicturePair pair = pairOf(grey(8, 5, .5f), grey(8, 5, .5f));
  for (size_t p = 0; p < pair.test.pixelCount(); ++p) pair.test.plane(0)[p] += .3f;
  EXPECT_NEAR(difference(pair, Metric::AbsDiff).value, .1, 1e-6);
  EXPECT_NEAR(difference(pair, Metric::Rmse).value, .3 / std::sqrt(3), 1e-6);
  EXPECT_NEAR(difference(pair, Metric::Psnr).value, -20 * std::log10(.3 / std::sqrt(3)), 1e-4);
  pair.scale = .25f;  // white is 4: 12 dB more room
  EXPECT_NEAR(difference(pair, Metric::Psnr).value, 20 * std::log10(4 * std::sqrt(3) / .3), 1e-4);
}

TEST(Difference, RmseOverThePictureIsNotTheMeanOverPixels) {
  PicturePair pair = pairOf(grey(2, 1, 0), grey(2, 1, 0));
  for (int c = 0; c < 3; ++c) pair.test.plane(c)[0] = 1;
  const Difference d = difference(pair, Metric::Rmse);
  EXPECT_NEAR(d.value, std::sqrt(.5), 1e-9);
  EXPECT_NEAR(d.statistics.mean, .5, 1e-9);
}

TEST(Difference, PixelsThatAreNotFiniteAreLeftOutAndCounted) {
  PicturePair pair = pairOf(grey(4, 4, .5f), grey(4, 4, .4f));
  pair.test.plane(2)[3] = NAN;
  pair.reference.plane(0)[9] = INFINITY;
  for (const Metric metric : {Metric::DeltaE2000, Metric::AbsDiff, Metric::Rmse, Metric::Psnr}) {
    const Difference d = difference(pair, metric);
    EXPECT_EQ(d.statistics.notFinite, 2u);
    EXPECT_TRUE(std::isfinite(d.value));
    EXPECT_TRUE(std::isnan(d.map.plane(0)[3]));
  }
}

TEST(Difference, TheShareAboveAThresholdIsOfTheFinitePixels) {
  PicturePair pair = pairOf(grey(10, 1, .5f), grey(10, 1, .5f));
  for (int p = 0; p < 3; ++p)
    for (int c = 0; c < 3; ++c) pair.test.plane(c)[p] = .7f;
  pair.test.plane(0)[9] = NAN;
  const DifferenceOptions options{{}, .1};
  EXPECT_DOUBLE_EQ(*difference(pair, Metric::AbsDiff, options).shareAbove, 3. / 9);
  EXPECT_DOUBLE_EQ(*difference(pair, Metric::DeltaE2000, options).shareAbove, 3. / 9);
  EXPECT_FALSE(difference(pair, Metric::Psnr, options).shareAbove);
  EXPECT_FALSE(difference(pair, Metric::AbsDiff).shareAbove);
}

TEST(Difference, IsOfAsManyChannelsAsThereAre) {
  const ImageSpec spec{2, 1, {"a", "b"}, "data"};
  const PicturePair pair = pairOf(Image(spec, .5f), Image(spec, .5f));
  EXPECT_EQ(difference(pair, Metric::AbsDiff).value, 0);
  PicturePair other = pairOf(Image(spec, .5f), Image(spec, .5f));
  other.test.plane(1)[0] = .9f;
  EXPECT_NEAR(difference(other, Metric::AbsDiff).value, .4 / 4, 1e-6);
  EXPECT_NEAR(difference(other, Metric::Rmse).value, std::sqrt(.16 / 4), 1e-6);
}

TEST(Difference, WithoutOneFinitePixelIsAnError) {
  EXPECT_THROW((void)difference(pairOf(grey(3, 3, NAN), grey(3, 3, 0)), Metric::Rmse), InputError);
}

TEST(Difference, CodeValuesAreDecodedForDeltaE) {
  // sRGB .5 against .5 + 1/255: the same as their linear values compared.
  const double lower = .214041;
  const double upper = std::pow((.5 + 1 / 255. + .055) / 1.055, 2.4);
  const double coded =
      difference(pairOf(grey(2, 2, .5f + 1 / 255.f), grey(2, 2, .5f), true), Metric::DeltaE2000).value;
  const double linear =
      difference(pairOf(grey(2, 2, static_cast<float>(upper)), grey(2, 2, static_cast<float>(lower))),
                 Metric::DeltaE2000)
          .value;
  EXPECT_NEAR(coded, linear, 1e-3);
  EXPECT_GT(coded, .1);
}

TEST(Difference, TheScaleBringsTheReferencesBrightPartToNineTenths) {
  Image reference = grey(1000, 1, 0);
  for (int c = 0; c < 3; ++c)
    for (int x = 0; x < 1000; ++x) reference.plane(c)[x] = static_cast<float>(x);
  reference.plane(0)[5] = INFINITY;
  EXPECT_NEAR(displayScale(reference.view()), .9 / 994.0, 1e-5);
  EXPECT_EQ(displayScale(grey(3, 3, 0).view()), 1);
}

TEST(Difference, MetricsAreNamedAndUnknownOnesListed) {
  EXPECT_THAT(metricsFromNames("psnr,de2000,psnr"), testing::ElementsAre(Metric::Psnr, Metric::DeltaE2000));
  EXPECT_EQ(metricName(Metric::AbsDiff), "absdiff");
  try {
    (void)metricsFromNames("ssim");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("ssim"));
    EXPECT_THAT(e.what(), testing::HasSubstr("de2000, absdiff, rmse or psnr"));
  }
  EXPECT_THROW((void)metricsFromNames(""), InputError);
}

TEST(DifferenceMap, ShowsLargerDifferencesBrighterAndLostPixelsMagenta) {
  PicturePair pair = pairOf(grey(60, 200, 0), grey(60, 200, 0));
  for (int x = 0; x < 60; ++x) pair.test.plane(1)[x] = static_cast<float>(x) / 60;
  pair.test.plane(0)[59] = NAN;
  const Image map = drawDifferenceMap(difference(pair, Metric::AbsDiff), .33);
  EXPECT_EQ(map.height(), 200);
  EXPECT_GT(map.width(), 60);
  const auto brightness = [&](int x) {
    return map.view().at(0, x, 0) + map.view().at(1, x, 0) + map.view().at(2, x, 0);
  };
  for (int x = 6; x < 58; x += 6) EXPECT_GT(brightness(x), brightness(x - 6));
  EXPECT_EQ(map.view().at(0, 59, 0), 1);
  EXPECT_EQ(map.view().at(1, 59, 0), 0);
  EXPECT_EQ(map.view().at(2, 59, 0), 1);
}

}  // namespace
}  // namespace swaplight
