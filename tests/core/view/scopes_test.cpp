#include "core/view/scopes/scopes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "core/ocio/luminance.h"

namespace swaplight {
namespace {

/// A sample of data: codes are 255 times the linear values.
ScopeSample sampleOf(const Image& image, int maxPixels = 1 << 30) {
  const Pyramid pyramid(image.view());
  const ViewLayer layer{&pyramid};
  return scopeSample({&layer, 1}, {0, 0, image.width(), image.height()}, DisplayTable(nullptr, {}),
                     maxPixels);
}

Image filled(int width, int height, const Rgb& color) {
  Image image(ImageSpec::rgb(width, height));
  for (int c = 0; c < 3; ++c) std::fill_n(image.plane(c), image.pixelCount(), color[c]);
  return image;
}

uint64_t total(const std::vector<uint32_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), uint64_t{0});
}

TEST(ScopeSample, TakesWholeRowsEvenlySpread) {
  Image image(ImageSpec::rgb(100, 90));
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < 90; ++y) std::fill_n(image.span().row(c, y), 100, static_cast<float>(y));
  const ScopeSample sample = sampleOf(image, 950);
  ASSERT_EQ(sample.width(), 100);
  ASSERT_EQ(sample.height(), 9);
  for (int row = 0; row < 9; ++row)
    EXPECT_EQ(sample.linear.view().at(0, 50, row), 10.0F * static_cast<float>(row) + 5);
}

TEST(ScopeSample, OfARegionHoldsOnlyIt) {
  Image image = filled(40, 30, Rgb(0.1F));
  for (int y = 10; y < 20; ++y) std::fill_n(image.span().row(0, y) + 5, 8, 0.75F);
  const Pyramid pyramid(image.view());
  const ViewLayer layer{&pyramid};
  const ScopeSample sample = scopeSample({&layer, 1}, {5, 10, 8, 10}, DisplayTable(nullptr, {}));
  EXPECT_EQ(total(codeHistogram(sample).counts[0]), 80U);
  EXPECT_EQ(codeHistogram(sample).counts[0][191], 80U);
}

TEST(ScopeSample, OfCodesShowsThemAsTheyAreAndTheirLight) {
  Image image = filled(40, 30, Rgb(0.1F));
  for (int y = 10; y < 20; ++y) std::fill_n(image.span().row(1, y) + 5, 8, 0.75F);
  const ScopeSample sample = scopeSampleOfCodes(image.view(), {5, 10, 8, 10});
  ASSERT_EQ(sample.width(), 8);
  ASSERT_EQ(sample.height(), 10);
  EXPECT_EQ(codeHistogram(sample).counts[1][191], 80U);
  EXPECT_NEAR(sample.linear.view().at(1, 3, 4), 0.5225F, 1e-4);  // IEC 61966-2-1 of 0.75
  EXPECT_EQ(scopeSampleOfCodes(image.view(), {0, 0, 40, 30}, 40 * 7).height(), 7);
}

TEST(Scopes, AWaveformShowsARampAsADiagonal) {
  Image image(ImageSpec::rgb(256, 10));
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < 10; ++y)
      for (int x = 0; x < 256; ++x) image.span().at(c, x, y) = static_cast<float>(x) / 255;
  const ScopeCounts luma = waveform(sampleOf(image), ScopeChannel::Luma, 256);
  EXPECT_EQ(total(luma.counts), 2560U);
  for (int x = 0; x < 256; ++x) EXPECT_EQ(luma.at(x, 255 - x), 10U) << x;
}

TEST(Scopes, AParadeTellsTheChannelsApart) {
  const ScopeSample sample = sampleOf(filled(64, 64, {1, 0.4F, 0}));
  EXPECT_EQ(waveform(sample, ScopeChannel::Red, 64).at(10, 0), 64U);
  EXPECT_EQ(waveform(sample, ScopeChannel::Green, 64).at(10, 255 - 102), 64U);
  EXPECT_EQ(waveform(sample, ScopeChannel::Blue, 64).at(10, 255), 64U);
}

TEST(Scopes, TheVectorscopePutsNeutralInTheMiddleAndColoursWhereTheyBelong) {
  EXPECT_EQ(vectorscope(sampleOf(filled(8, 8, Rgb(0.5F))), 256).at(128, 128), 64U);
  // Published Y'CbCr of pure Rec.709 red: Cb -0.1146, Cr 0.5.
  const auto [x, y] = vectorscopePlace({1, 0, 0});
  EXPECT_NEAR(x, 0.5 - 0.1146, 1e-3);
  EXPECT_NEAR(y, 0, 1e-3);
  EXPECT_NEAR(vectorscopePlace({0, 0, 1})[0], 1, 1e-3);
}

TEST(Scopes, ChromaticitiesAreThoseOfThePrimaries) {
  const ColorConfig config("");
  const glm::mat3 xyz = xyzFromLinear(config, "lin_rec709");
  const auto places = [&](const Rgb& color) {
    const ScopeCounts scope = chromaticityScope(sampleOf(filled(4, 4, color)), xyz, 200);
    const auto at = std::find(scope.counts.begin(), scope.counts.end(), 16U) - scope.counts.begin();
    const ptrdiff_t column = at % 200, row = at / 200;
    return std::array<double, 2>{(static_cast<double>(column) + 0.5) / 200 * 0.8,
                                 (1 - (static_cast<double>(row) + 0.5) / 200) * 0.9};
  };
  EXPECT_NEAR(places({1, 0, 0})[0], 0.64, 0.003);
  EXPECT_NEAR(places({1, 0, 0})[1], 0.33, 0.003);
  EXPECT_NEAR(places(Rgb(1))[0], 0.3127, 0.003);
  EXPECT_NEAR(places(Rgb(1))[1], 0.3290, 0.003);
  EXPECT_EQ(total(chromaticityScope(sampleOf(filled(4, 4, Rgb(0))), xyz).counts), 0U);
  // AP1's luminance weights, as ACES publishes them.
  const Rgb ap1 = luminanceWeights(config, "acescg");
  EXPECT_NEAR(ap1.r, 0.2722, 0.02);
  EXPECT_NEAR(ap1.r + ap1.g + ap1.b, 1, 1e-3);
}

TEST(Scopes, HistogramsCountEveryPixelOnce) {
  Image image = filled(50, 20, Rgb(0.18F));
  image.plane(0)[0] = -1;
  image.plane(0)[1] = 1000;
  image.plane(0)[2] = std::numeric_limits<float>::quiet_NaN();
  const ScopeSample sample = sampleOf(image);
  const Histogram stops = stopsHistogram(sample, kRec709Luminance, -8, 8, 160);
  for (const std::vector<uint32_t>& counts : stops.counts) EXPECT_EQ(total(counts), 1000U);
  EXPECT_EQ(stops.counts[1][80], 1000U);
  EXPECT_EQ(stops.counts[0][0], 2U);    // negative, and not a number
  EXPECT_EQ(stops.counts[0][159], 1U);  // beyond the end
  const Histogram linear = linearHistogram(sample, kRec709Luminance, 1, 100);
  EXPECT_EQ(linear.counts[2][18], 1000U);
  EXPECT_EQ(codeHistogram(sample).counts[2][46], 1000U);
}

TEST(Scopes, LightGrowsWithTheCountAndAddsUp) {
  const ScopeCounts counts{3, 1, {0, 1, 100}};
  std::vector<uint8_t> rgba(12, 0);
  addScopeLight(counts, {1, 0, 0}, 100, rgba.data());
  addScopeLight(counts, {0, 0, 0.5F}, 100, rgba.data());
  EXPECT_EQ(rgba[0], 0);
  EXPECT_EQ(rgba[3], 255);
  EXPECT_GT(rgba[4], 20);
  EXPECT_LT(rgba[4], rgba[8]);
  EXPECT_EQ(rgba[8], 255);
  EXPECT_NEAR(rgba[10], 127, 1);
}

}  // namespace
}  // namespace swaplight
