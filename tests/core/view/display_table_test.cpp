#include "core/view/display/display_table.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>

#include "core/color/srgb.h"
#include "core/view/display/exact_view.h"
#include "core/view/display/false_color.h"

namespace swaplight {
namespace {

/// A view of the built-in configuration whose name contains some words.
ViewFunction viewNamed(const std::string& words) {
  const ColorConfig config("");
  for (const std::string& display : config.displays())
    for (const std::string& view : config.views(display))
      if (fmt::format("{} {}", display, view).find(words) != std::string::npos)
        return exactView(config, "lin_rec709", {display, view});
  throw std::logic_error("no view is named " + words);
}

ViewFunction srgbView() {
  return [](ImageSpan pixels) {
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x) pixels.at(c, x, y) = srgbFromLinear(pixels.at(c, x, y));
  };
}
ViewFunction p3View() {
  return viewNamed("P3-D65 P3-D65");
}
ViewFunction acesView() {
  return viewNamed("ACES");
}

/// Colours of these stops over full scale, from grey to as saturated as random ones are.
Image manyColors(float lowest, float highest) {
  Image image(ImageSpec::rgb(512, 256));
  std::mt19937 random(3);
  std::uniform_real_distribution<float> stops(lowest, highest), level(0, 1);
  for (size_t p = 0; p < image.pixelCount(); ++p) {
    const float strength = std::exp2(stops(random)), saturation = level(random);
    for (int c = 0; c < 3; ++c) image.plane(c)[p] = strength * (1 - saturation * level(random));
  }
  return image;
}

struct CodeError {
  double mean = 0;
  double worst = 0;
  double beyondTwo = 0;  ///< share of the values that are more than two codes off
};

CodeError errorOf(const ViewFunction& view, float lowest = -9, float highest = 3) {
  const DisplayTable table(std::make_shared<const BakedView>(view), {});
  Image image = manyColors(lowest, highest);
  std::vector<uint8_t> codes(image.pixelCount() * 4);
  table.apply(image.plane(0), image.plane(1), image.plane(2), static_cast<int>(image.pixelCount()),
              codes.data());
  view(image.span());
  CodeError error;
  const double count = 3.0 * static_cast<double>(image.pixelCount());
  for (size_t p = 0; p < image.pixelCount(); ++p)
    for (int c = 0; c < 3; ++c) {
      const double exact = 255.0 * std::clamp(image.plane(c)[p], 0.0F, 1.0F);
      const double off = std::abs(exact - codes[4 * p + static_cast<size_t>(c)]);
      error.mean += off / count;
      error.worst = std::max(error.worst, off);
      if (off > 2) error.beyondTwo += 1 / count;
    }
  return error;
}

TEST(DisplayTable, PlainSrgbIsWithinRounding) {
  EXPECT_LT(errorOf(srgbView()).worst, 0.6);
}

TEST(DisplayTable, AViewOfOtherPrimariesIsFoundToBeAMatrixAndCurves) {
  EXPECT_TRUE(BakedView(p3View()).exact());
  EXPECT_LT(errorOf(p3View()).worst, 0.6);
}

TEST(DisplayTable, AFilmLikeViewIsWithinTwoCodesButForVerySaturatedPixels) {
  EXPECT_FALSE(BakedView(acesView()).exact());
  const CodeError error = errorOf(acesView());
  EXPECT_LT(error.mean, 0.3);
  EXPECT_LT(error.beyondTwo, 1e-3);
  RecordProperty("worst", std::to_string(error.worst));
}

TEST(DisplayTable, TheRolledOffViewIsWithinTwoCodesButForVerySaturatedPixels) {
  const std::initializer_list<std::pair<const char*, double>> kMostBeyondTwo = {
      {"sRGB AgX", 0.0}, {"Rec.709 AgX", 2e-3}, {"P3-D65 AgX", 1e-3}};
  for (const auto& [view, mostBeyondTwo] : kMostBeyondTwo) {
    const CodeError error = errorOf(viewNamed(view));
    EXPECT_LT(error.mean, 0.3) << view;
    EXPECT_LE(error.beyondTwo, mostBeyondTwo) << view;
    EXPECT_LE(error.worst, 8.5) << view;
  }
}

TEST(DisplayTable, WhatIsBrighterThanSixtyFourTimesFullScaleIsShownToo) {
  for (const char* view : {"PQ ACES HDR", "HLG ACES HDR", "sRGB ACES SDR"}) {
    const CodeError error = errorOf(viewNamed(view), 6, 16);
    EXPECT_LT(error.mean, 0.35) << view;
    EXPECT_LE(error.worst, 2.0) << view;
    EXPECT_EQ(error.beyondTwo, 0) << view;
  }
}

TEST(DisplayTable, TheEncodingOfTheDisplayIsFound) {
  for (const char* view : {"P3-D65 Hable", "P3-D65 Reinhard", "HLG 203"})
    EXPECT_LT(errorOf(viewNamed(view)).worst, 3) << view << ": nearly 6 if it were taken for sRGB";
}

std::array<int, 4> codesOf(const DisplayTable& table, const Rgb& color) {
  std::array<uint8_t, 4> codes{};
  table.apply(&color.r, &color.g, &color.b, 1, codes.data());
  return {codes[0], codes[1], codes[2], codes[3]};
}

int srgbCode(float linear) {
  return static_cast<int>(std::lround(255 * srgbFromLinear(linear)));
}

TEST(DisplayTable, ExposureGammaAndChannelActInTheirOrder) {
  const auto view = std::make_shared<const BakedView>(srgbView());
  ViewSettings settings;
  settings.exposureStops = -1;
  DisplayTable table(view, settings);
  EXPECT_EQ(codesOf(table, {0.5F, 0.25F, 1}),
            (std::array<int, 4>{srgbCode(0.25F), srgbCode(0.125F), srgbCode(0.5F), 255}));
  settings = {};
  settings.gamma = 2;
  table.change(settings);
  const int expected = static_cast<int>(std::lround(255 * std::sqrt(srgbFromLinear(0.25F))));
  EXPECT_EQ(codesOf(table, Rgb(0.25F))[0], expected);
  settings = {};
  settings.channel = ViewChannel::Green;
  table.change(settings);
  EXPECT_EQ(codesOf(table, {0.5F, 0.25F, 1}),
            (std::array<int, 4>{srgbCode(0.25F), srgbCode(0.25F), srgbCode(0.25F), 255}));
  settings.channel = ViewChannel::Luminance;
  table.change(settings);
  EXPECT_EQ(codesOf(table, Rgb(0.25F))[2], srgbCode(0.25F));
}

TEST(DisplayTable, FalseColorShowsTheBandOfTheLuminance) {
  ViewSettings settings;
  settings.falseColor = true;
  const DisplayTable table(nullptr, settings);
  EXPECT_EQ(codesOf(table, Rgb(0.18F)), (std::array<int, 4>{128, 128, 128, 255}));
  EXPECT_EQ(codesOf(table, Rgb(0)), (std::array<int, 4>{0, 0, 0, 255}));
  EXPECT_EQ(codesOf(table, Rgb(18)), (std::array<int, 4>{255, 255, 255, 255}));
  const Rgb twoUp = falseColor(0.72F);
  EXPECT_EQ(codesOf(table, Rgb(0.72F))[0], std::lround(255 * twoUp.r));
}

TEST(DisplayTable, ValuesThatAreNotFiniteAreShownAsTheLargestOrAsBlack) {
  const DisplayTable table(std::make_shared<const BakedView>(srgbView()), {});
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(codesOf(table, {infinity, -infinity, std::numeric_limits<float>::quiet_NaN()}),
            (std::array<int, 4>{255, 0, 0, 255}));
}

TEST(DisplayTable, DataIsShownAsItIs) {
  const DisplayTable table(nullptr, {});
  EXPECT_EQ(codesOf(table, {0.5F, 1.5F, -1}), (std::array<int, 4>{128, 255, 0, 255}));
}

TEST(FalseColor, BandsRiseAndMiddleGreyIsGrey) {
  const auto bands = falseColorBands();
  for (size_t i = 1; i < bands.size(); ++i) EXPECT_LT(bands[i - 1].stops, bands[i].stops);
  EXPECT_EQ(falseColor(0.18F), Rgb(0.5F));
  EXPECT_EQ(falseColor(std::numeric_limits<float>::quiet_NaN()), bands.front().color);
}

}  // namespace
}  // namespace swaplight
