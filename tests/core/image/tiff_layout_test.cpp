#include "core/image/io/tiff_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/image/io/image_io.h"
#include "tests/support/made_tiff.h"

namespace swaplight {
namespace {

using test::MadeTiff;
using test::TemporaryFolder;
using ::testing::HasSubstr;

/// Expects that every pixel is `expected`, or that the file is refused for what it is.
void expectPixels(const MadeTiff& tiff, const std::vector<float>& expected, float tolerance) {
  const TemporaryFolder folder;
  tiff.write(folder / "a.tif");
  const Image image = readImage(folder / "a.tif").image;
  ASSERT_EQ(image.channelCount(), static_cast<int>(expected.size()));
  for (int c = 0; c < image.channelCount(); ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p)
      ASSERT_NEAR(image.plane(c)[p], expected[static_cast<size_t>(c)], tolerance)
          << "channel " << c << ", pixel " << p;
}

void expectRefused(const MadeTiff& tiff, const std::string& words) {
  const TemporaryFolder folder;
  tiff.write(folder / "a.tif");
  const std::string error = test::inputError([&] { static_cast<void>(readImage(folder / "a.tif")); });
  EXPECT_THAT(error, HasSubstr("a.tif: is a TIFF of " + words));
  EXPECT_THAT(error, HasSubstr("Save it as RGB"));
}

TEST(TiffLayout, InksAreReadRightlyOrRefused) {
  for (const int bits : {1, 2, 4, 6, 8, 10, 12, 14, 16, 32})
    for (const bool tiled : {false, true})
      for (const bool separate : {false, true}) {
        SCOPED_TRACE(fmt::format("{} bits, tiled {}, separate {}", bits, tiled, separate));
        const uint64_t most = (uint64_t{1} << bits) - 1;
        const std::vector<uint64_t> codes = {0, most / 2, most, most / 4};
        const MadeTiff tiff{.bits = bits, .codes = codes, .separate = separate, .tiled = tiled};
        const bool read = !tiled && bits <= 16 && (separate || bits == 8 || bits == 16);
        if (!read) {
          expectRefused(tiff, "four inks (CMYK)");
          continue;
        }
        const auto part = [&](size_t c) { return static_cast<float>(codes[c]) / static_cast<float>(most); };
        std::vector<float> rgb;
        for (size_t c = 0; c < 3; ++c) rgb.push_back((1 - part(c)) * (1 - part(3)));
        expectPixels(tiff, rgb, bits <= 8 ? 1.01F / 255 : 1.01F / 65535);
      }
}

TEST(TiffLayout, OtherInksAreReadAsTheyAre) {
  expectPixels({.bits = 8, .codes = {51, 102, 153, 204, 255}, .tiled = true}, {0.2F, 0.4F, 0.6F, 0.8F, 1},
               1e-6F);
}

TEST(TiffLayout, NumbersOf24And64BitsAreRefused) {
  for (const bool tiled : {false, true})
    for (const bool separate : {false, true}) {
      const std::vector<uint64_t> codes = {0x000001, 0x800000, 0x123456};
      expectRefused({.photometric = 2, .bits = 24, .codes = codes, .separate = separate, .tiled = tiled},
                    "numbers of 24 bits");
      expectRefused({.photometric = 2,
                     .bits = 64,
                     .codes = {0x3fe0000000000000, 0, 0},
                     .separate = separate,
                     .tiled = tiled,
                     .sampleFormat = 3},
                    "numbers of 64 bits");
    }
}

TEST(TiffLayout, ColourTablesAreReadRightlyOrRefused) {
  for (const int bits : {1, 2, 4, 6, 8, 16})
    for (const bool tiled : {false, true}) {
      SCOPED_TRACE(fmt::format("{} bits, tiled {}", bits, tiled));
      const size_t entries = size_t{1} << bits;
      MadeTiff tiff{.photometric = 3, .bits = bits, .codes = {entries - 2}, .tiled = tiled};
      tiff.palette.resize(3 * entries);
      tiff.palette[entries - 2] = 257 * 51;
      tiff.palette[2 * entries - 2] = 257 * 102;
      tiff.palette[3 * entries - 2] = 257 * 153;
      if (bits == 6)
        expectRefused(tiff, "a colour table of 6 bits");
      else
        expectPixels(tiff, {0.2F, 0.4F, 0.6F}, 1e-6F);
    }
}

TEST(TiffLayout, AColourTableWithAlphaIsRefused) {
  MadeTiff tiff{.photometric = 3, .codes = {7, 255}, .alpha = true};
  tiff.palette.resize(3 * 256);
  expectRefused(tiff, "a colour table with transparency");
}

TEST(TiffLayout, WhiteMayBeZeroInOneChannel) {
  expectPixels({.photometric = 0, .codes = {51}}, {0.8F}, 1e-6F);
  expectRefused({.photometric = 0, .codes = {51, 255}, .alpha = true}, "several channels whose white is 0");
}

}  // namespace
}  // namespace swaplight
