#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/image/half.h"
#include "core/image/io/image_io.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Different in every pixel and channel, 0..1.
Image pattern(int width, int height, std::vector<std::string> channels = {"R", "G", "B"}) {
  Image image({width, height, std::move(channels), "lin_rec709"});
  for (int c = 0; c < image.channelCount(); ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p)
      image.plane(c)[p] = static_cast<float>((p * 7 + static_cast<size_t>(c) * 31) % 97) / 96.0F;
  return image;
}

float largestDifference(const Image& a, const Image& b) {
  EXPECT_EQ(a.width(), b.width());
  EXPECT_EQ(a.height(), b.height());
  EXPECT_EQ(a.channelCount(), b.channelCount());
  float largest = 0;
  for (int c = 0; c < a.channelCount(); ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p)
      largest = std::max(largest, std::abs(a.plane(c)[p] - b.plane(c)[p]));
  return largest;
}

struct FormatCase {
  const char* name;
  const char* pixelType;
  int bits;
  float tolerance;
};

class EveryFormat : public ::testing::TestWithParam<FormatCase> {};

TEST_P(EveryFormat, KeepsPixelsToItsOwnPrecision) {
  const TemporaryFolder folder;
  const Image image = pattern(37, 21);
  WriteOptions options;
  options.pixelType = GetParam().pixelType;
  writeImage(image, folder / GetParam().name, options);
  const ImageFile file = readImage(folder / GetParam().name);
  EXPECT_LE(largestDifference(image, file.image), GetParam().tolerance);
  EXPECT_EQ(file.info.bits, GetParam().bits);
  EXPECT_THAT(file.image.spec().channels, ElementsAre("R", "G", "B"));
  EXPECT_EQ(folder.fileCount(), 1U);
}

INSTANTIATE_TEST_SUITE_P(
    ImageIo, EveryFormat,
    ::testing::Values(FormatCase{"a.exr", "half", 16, 2.5e-4F}, FormatCase{"b.exr", "float", 32, 0},
                      FormatCase{"a.png", "uint8", 8, 0.51F / 255},
                      FormatCase{"b.png", "uint16", 16, 0.51F / 65535},
                      FormatCase{"a.tif", "uint8", 8, 0.51F / 255},
                      FormatCase{"b.tiff", "uint16", 16, 0.51F / 65535}, FormatCase{"c.tif", "float", 32, 0},
                      FormatCase{"a.hdr", "float", 32, 1.0F / 128}, FormatCase{"a.JPG", "uint8", 8, 0.2F}));

TEST(ImageIo, OnePixelWorksInEveryFormat) {
  const TemporaryFolder folder;
  for (const char* name : {"a.exr", "a.png", "a.tif", "a.jpg", "a.hdr"}) {
    writeImage(Image(ImageSpec::rgb(1, 1), 0.5F), folder / name);
    const Image image = readImage(folder / name).image;
    ASSERT_EQ(image.pixelCount(), 1U) << name;
    EXPECT_NEAR(image.plane(1)[0], 0.5F, 0.01F) << name;
  }
}

TEST(ImageIo, MixedHalfAndFloatChannelsTextAndChromaticitiesSurvive) {
  const TemporaryFolder folder;
  Image image = pattern(40, 300, {"R", "G", "B", "key.R", "beta.key", "quality.sigma"});
  image.setColorSpace("acescg");
  WriteOptions options;
  options.channelTypes = {"half", "half", "half", "half", "float", "float"};
  options.text = {{"swaplight/report", std::string(100000, 'x')}, {"note", "caf\xc3\xa9"}};
  options.compression = "piz";
  writeImage(image, folder / "set.exr", options);
  ImageFileInfo info;
  const ImageSpec spec = readImageSpec(folder / "set.exr", &info);
  EXPECT_EQ(spec.colorSpace, "acescg");
  EXPECT_EQ(info.text["swaplight/report"].size(), 100000U);
  EXPECT_EQ(info.text["note"], "caf\xc3\xa9");
  EXPECT_EQ(info.text["compression"], "piz");
  const Image back = readImage(folder / "set.exr").image;
  ASSERT_EQ(back.spec().channels.size(), 6U);
  for (int c = 0; c < 6; ++c) {
    const float* stored = back.plane(back.channelIndex(image.spec().channels[static_cast<size_t>(c)]));
    for (size_t p = 0; p < image.pixelCount(); ++p)
      ASSERT_EQ(stored[p], c < 4 ? roundedToHalf(image.plane(c)[p]) : image.plane(c)[p]) << c;
  }
}

TEST(ImageIo, HalfClampsInsteadOfInfinityAndIntegersClampAndEndNaN) {
  const TemporaryFolder folder;
  Image image(ImageSpec::rgb(3, 1), 0.0F);
  const float values[3] = {1e9F, -1e9F, std::nanf("")};
  for (int c = 0; c < 3; ++c) std::copy_n(values, 3, image.plane(c));
  writeImage(image, folder / "a.exr");
  const Image half = readImage(folder / "a.exr").image;
  EXPECT_EQ(half.plane(0)[0], 65504.0F);
  EXPECT_EQ(half.plane(0)[1], -65504.0F);
  EXPECT_TRUE(std::isnan(half.plane(0)[2]));
  writeImage(image, folder / "a.png");
  const Image png = readImage(folder / "a.png").image;
  EXPECT_EQ(png.plane(0)[0], 1.0F);
  EXPECT_EQ(png.plane(0)[1], 0.0F);
  EXPECT_EQ(png.plane(0)[2], 0.0F);
}

TEST(ImageIo, AlphaIsNotMultipliedIn) {
  const TemporaryFolder folder;
  Image image(ImageSpec{2, 2, {"R", "G", "B", "A"}, "srgb"}, 1.0F);
  std::fill_n(image.plane(3), 4, 0.2F);
  for (const char* name : {"a.png", "a.tif", "a.exr"}) {
    writeImage(image, folder / name);
    EXPECT_LT(largestDifference(image, readImage(folder / name).image), 1e-3F) << name;
  }
}

TEST(ImageIo, GreyAndGreyAlphaKeepTheirChannels) {
  const TemporaryFolder folder;
  writeImage(pattern(5, 5, {"Y"}), folder / "grey.png");
  writeImage(pattern(5, 5, {"Y", "A"}), folder / "alpha.png");
  EXPECT_EQ(readImage(folder / "grey.png").image.channelCount(), 1);
  EXPECT_EQ(readImage(folder / "alpha.png").image.channelCount(), 2);
}

/// Writes parts with OpenImageIO itself, so that our reader is not only tested against our writer.
void writeParts(const std::filesystem::path& file, std::vector<OIIO::ImageSpec> specs) {
  const auto out = OIIO::ImageOutput::create("openexr");
  ASSERT_TRUE(out->open(file.string(), static_cast<int>(specs.size()), specs.data()));
  for (size_t i = 0; i < specs.size(); ++i) {
    if (i > 0) {
      ASSERT_TRUE(out->open(file.string(), specs[i], OIIO::ImageOutput::AppendSubimage));
    }
    const std::vector<float> pixels(specs[i].image_pixels() * static_cast<size_t>(specs[i].nchannels),
                                    0.25F * static_cast<float>(i + 1));
    ASSERT_TRUE(out->write_image(OIIO::TypeFloat, pixels.data()));
  }
  ASSERT_TRUE(out->close());
}

OIIO::ImageSpec partSpec(const std::string& name, int width, int height, int channels = 3) {
  OIIO::ImageSpec spec(width, height, channels, OIIO::TypeHalf);
  spec.attribute("oiio:subimagename", name);
  return spec;
}

TEST(ImageIo, PartsBecomeLayers) {
  const TemporaryFolder folder;
  writeParts(folder / "parts.exr", {partSpec("rgb", 8, 4), partSpec("key", 8, 4), partSpec("fill", 8, 4)});
  const ImageFile file = readImage(folder / "parts.exr");
  EXPECT_EQ(file.info.parts, 3);
  EXPECT_THAT(file.image.spec().channels,
              ElementsAre("R", "G", "B", "key.R", "key.G", "key.B", "fill.R", "fill.G", "fill.B"));
  EXPECT_EQ(file.image.plane(0)[5], 0.25F);
  EXPECT_EQ(file.image.plane(5)[31], 0.5F);
  EXPECT_EQ(file.image.plane(6)[0], 0.75F);
}

TEST(ImageIo, TheDisplayWindowIsTheImage) {
  const TemporaryFolder folder;
  OIIO::ImageSpec inside = partSpec("", 4, 3);
  inside.x = 2, inside.y = 5;
  inside.full_width = 10, inside.full_height = 12;
  writeParts(folder / "crop.exr", {inside});
  Image image = readImage(folder / "crop.exr").image;
  ASSERT_EQ(image.width(), 10);
  ASSERT_EQ(image.height(), 12);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 10; ++x)
      ASSERT_EQ(image.view().at(1, x, y), x >= 2 && x < 6 && y >= 5 && y < 8 ? 0.25F : 0.0F) << x << " " << y;

  OIIO::ImageSpec overscan = partSpec("", 20, 18);
  overscan.x = -3, overscan.y = -4;
  overscan.full_width = 10, overscan.full_height = 12;
  writeParts(folder / "overscan.exr", {overscan});
  image = readImage(folder / "overscan.exr").image;
  ASSERT_EQ(image.width(), 10);
  EXPECT_EQ(image.view().at(2, 9, 11), 0.25F);

  overscan.x = 100;
  writeParts(folder / "apart.exr", {overscan});
  EXPECT_THAT(inputError([&] { (void)readImage(folder / "apart.exr"); }),
              HasSubstr("outside of its display window"));
}

TEST(ImageIo, TilesAreRead) {
  const TemporaryFolder folder;
  const Image image = pattern(101, 67);
  OIIO::ImageSpec spec(101, 67, 3, OIIO::TypeFloat);
  spec.tile_width = spec.tile_height = 32;
  std::vector<float> pixels;
  for (size_t p = 0; p < image.pixelCount(); ++p)
    for (int c = 0; c < 3; ++c) pixels.push_back(image.plane(c)[p]);
  const auto out = OIIO::ImageOutput::create("openexr");
  ASSERT_TRUE(out->open((folder / "tiles.exr").string(), spec));
  ASSERT_TRUE(out->write_image(OIIO::TypeFloat, pixels.data()));
  ASSERT_TRUE(out->close());
  EXPECT_EQ(largestDifference(image, readImage(folder / "tiles.exr").image), 0.0F);
}

TEST(ImageIo, PicturesHeldOnTheirSideAreTurnedUpright) {
  const TemporaryFolder folder;
  // Stored: a bright pixel at the top left. Where it has to be in the upright picture, for each EXIF
  // orientation.
  const int width = 5, height = 3;
  const int at[9][2] = {{}, {0, 0}, {4, 0}, {4, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 4}, {0, 4}};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt16);
    spec.attribute("Orientation", orientation);
    std::vector<float> pixels(static_cast<size_t>(width) * height * 3, 0.0F);
    pixels[0] = 1;
    const auto out = OIIO::ImageOutput::create("tiff");
    ASSERT_TRUE(out->open((folder / "a.tif").string(), spec));
    ASSERT_TRUE(out->write_image(OIIO::TypeFloat, pixels.data()));
    ASSERT_TRUE(out->close());
    const Image image = readImage(folder / "a.tif").image;
    ASSERT_EQ(image.width(), orientation > 4 ? height : width);
    EXPECT_EQ(readImageSpec(folder / "a.tif").width, image.width());
    EXPECT_EQ(image.view().at(0, at[orientation][0], at[orientation][1]), 1.0F) << orientation;
  }
}

TEST(ImageIo, WhatIsNoPictureIsSaid) {
  const TemporaryFolder folder;
  const auto errorOf = [&](const std::string& name, const std::string& bytes) {
    test::writeBytes(folder / name, bytes);
    return inputError([&] { (void)readImage(folder / name); });
  };
  EXPECT_THAT(errorOf("text.exr", "hello"), HasSubstr("text.exr: is not a picture that this program reads"));
  EXPECT_THAT(errorOf("empty.png", ""), HasSubstr("empty.png: is empty"));
  EXPECT_THAT(errorOf("head.png", "\x89PNG\r\n\x1a\n"),
              HasSubstr("head.png: is not a complete png file: the file ends"));
  EXPECT_THAT(errorOf("head.exr", "\x76\x2f\x31\x01 rest"), HasSubstr("damaged or not a valid openexr file"));
  EXPECT_THAT(errorOf("camera.dng", "this is no photograph"), HasSubstr("damaged or not a valid raw file"));
  EXPECT_THAT(inputError([&] { (void)readImage(folder / "none.exr"); }), HasSubstr("none.exr: no such file"));
  EXPECT_THAT(inputError([&] { (void)readImage(folder.path()); }), HasSubstr("is a folder"));
}

TEST(ImageIo, TruncatedFilesAreErrorsWhereverTheyEnd) {
  const TemporaryFolder folder;
  for (const char* name : {"a.exr", "a.png", "a.tif", "a.jpg", "a.hdr"}) {
    writeImage(pattern(64, 64), folder / name);
    const std::string whole = test::readBytes(folder / name);
    for (const double part : {0.02, 0.3, 0.6, 0.9, 0.98}) {
      const std::string cut = std::string("cut_") + name;
      test::writeBytes(folder / cut,
                       whole.substr(0, static_cast<size_t>(part * static_cast<double>(whole.size()))));
      EXPECT_THAT(inputError([&] { (void)readImage(folder / cut); }), HasSubstr(cut)) << part;
    }
  }
}

TEST(ImageIo, ASizeThatNoMachineHoldsIsRefusedInWords) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "long.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 200000 +X 4\n");
  EXPECT_THAT(inputError([&] { (void)readImage(folder / "long.hdr"); }), HasSubstr("no side may be longer"));
  test::writeBytes(folder / "huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 131072 +X 131072\n");
  EXPECT_THAT(inputError([&] { (void)readImage(folder / "huge.hdr"); }), HasSubstr("that takes 206.2 GB"));
}

TEST(ImageIo, ADamagedPngIsAnError) {
  const TemporaryFolder folder;
  writeImage(pattern(64, 64), folder / "a.png");
  std::string bytes = test::readBytes(folder / "a.png");
  bytes[bytes.size() / 2] ^= 1;
  test::writeBytes(folder / "a.png", bytes);
  EXPECT_THAT(inputError([&] { (void)readImage(folder / "a.png"); }), HasSubstr("a checksum is wrong"));
}

TEST(ImageIo, UnwritableTargetsAreSaidAndNothingStaysBehind) {
  const TemporaryFolder folder;
  const auto errorOf = [&](const std::filesystem::path& file, const WriteOptions& options = {}) {
    return inputError([&] { writeImage(pattern(4, 4), file, options); });
  };
  EXPECT_THAT(errorOf(folder / "none/a.exr"), HasSubstr("does not exist. Create it"));
  EXPECT_THAT(errorOf(folder.path()), HasSubstr("names no format"));
  std::filesystem::create_directory(folder / "b.exr");
  EXPECT_THAT(errorOf(folder / "b.exr"), HasSubstr("is a folder"));
  EXPECT_THAT(errorOf(folder / "a.gif"), HasSubstr("Use .exr, .png, .tif, .jpg or .hdr"));
  EXPECT_THAT(errorOf("/proc/a.exr"), HasSubstr("cannot be written"));
  WriteOptions wrong;
  wrong.pixelType = "uint8";
  EXPECT_THAT(errorOf(folder / "c.exr", wrong), HasSubstr("holds half or float, not uint8"));
  wrong.pixelType = "double";
  EXPECT_THAT(errorOf(folder / "c.exr", wrong), HasSubstr("Known types"));
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(ImageIo, AZeroSizeImageCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_THAT(inputError([&] { writeImage(Image(ImageSpec::rgb(0, 4)), folder / "a.exr"); }),
              HasSubstr("there is nothing in it"));
}

}  // namespace
}  // namespace swaplight
