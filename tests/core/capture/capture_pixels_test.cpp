#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/capture/capture_pixels.h"
#include "core/image/io/image_io.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Two shots of one light, a smooth picture with values up to `largest`.
class Set {
 public:
  explicit Set(float largest = 0.7F, const std::string& extension = ".exr") {
    capture.folder = folder.path();
    capture.file = folder / "capture.json";
    capture.lights = {{"key", Role::Key, {}}};
    for (const char* name : {"one", "two"}) {
      capture.shots.push_back({name + extension, {Rgb(1)}, {}, 0, false, {}});
      images.push_back(ramp(largest));
    }
  }

  static Image ramp(float largest, int width = 96, int height = 64) {
    Image image(ImageSpec::rgb(width, height));
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p)
        image.plane(c)[p] = largest * static_cast<float>(p * 3 + static_cast<size_t>(c)) /
                            static_cast<float>(image.pixelCount() * 3 - 1);
    return image;
  }

  CapturePixels load(const WriteOptions& options = {}) {
    for (size_t k = 0; k < images.size(); ++k)
      writeImage(images[k], folder / capture.shots[k].image, options);
    return loadCapturePixels(test::builtinColors(), capture);
  }
  std::string error() {
    return inputError([&] { (void)loadCapturePixels(test::builtinColors(), capture); });
  }

  TemporaryFolder folder;
  Capture capture;
  std::vector<Image> images;
};

WriteOptions as(const std::string& type) {
  WriteOptions options;
  options.pixelType = type;
  return options;
}

TEST(CapturePixels, LinearFloatShotsComeAsTheyAre) {
  Set set;
  const CapturePixels pixels = set.load(as("float"));
  ASSERT_EQ(pixels.shots.size(), 2U);
  EXPECT_EQ(pixels.width(), 96);
  for (size_t p = 0; p < set.images[0].pixelCount(); ++p)
    ASSERT_EQ(pixels.shots[1].plane(2)[p], set.images[1].plane(2)[p]);
  EXPECT_THAT(pixels.clipLevel, ElementsAre(kInfinity, kInfinity));
  EXPECT_THAT(pixels.quantum, ElementsAre(0, 0));
  EXPECT_TRUE(pixels.rounding.empty());
  EXPECT_THAT(pixels.warnings, IsEmpty());
}

TEST(CapturePixels, SrgbShotsAreLinearised) {
  Set set(1, ".png");
  set.capture.colorSpace = "srgb";
  const CapturePixels pixels = set.load(as("uint8"));
  ASSERT_FALSE(pixels.rounding.empty());
  for (const auto& [value, variance] : pixels.rounding) {
    // The curve's slope is 1/12.92 near black, and from there rises as the 1.4/2.4th power of light.
    const double slope = value < .0031 ? 1 / 12.92 : 2.4 / 1.055 * std::pow(value, 1.4 / 2.4);
    EXPECT_NEAR(variance, std::pow(slope / (2.4 / 1.055), 2), .08 * variance) << value;
  }
  EXPECT_EQ(pixels.shots[0].spec().colorSpace, "lin_rec709");
  EXPECT_NEAR(pixels.quantum[0], 2.2749F / 255, 1e-4F);
  EXPECT_LT(pixels.clipLevel[0], 1);
  EXPECT_GT(pixels.clipLevel[0], 1 - pixels.quantum[0]);
  const size_t middle = set.images[0].pixelCount() / 2;
  const double code = std::round(set.images[0].plane(0)[middle] * 255) / 255;
  EXPECT_NEAR(pixels.shots[0].plane(0)[middle], std::pow((code + 0.055) / 1.055, 2.4), 1e-5);
}

TEST(CapturePixels, ScenePrimariesStay) {
  Set set;
  set.capture.colorSpace = "acescg";
  EXPECT_EQ(set.load(as("float")).shots[0].spec().colorSpace, "acescg");
  set.capture.colorSpace = "acescct";
  EXPECT_EQ(set.load(as("float")).shots[0].spec().colorSpace, "lin_rec709");
}

TEST(CapturePixels, TheBitsOfIntegersAreRecognised) {
  for (const int bits : {8, 10, 12, 14, 16}) {
    Set set(1, ".png");
    const auto levels = static_cast<float>((1 << bits) - 1);
    std::mt19937 random(1);
    for (Image& image : set.images)
      for (int c = 0; c < 3; ++c)
        for (size_t p = 0; p < image.pixelCount(); ++p)
          image.plane(c)[p] = static_cast<float>(random() % (1U << bits)) / levels;
    const CapturePixels pixels = set.load(as("uint16"));
    EXPECT_NEAR(pixels.quantum[0] * levels, 1, 0.01) << bits;
    EXPECT_LT(pixels.clipLevel[0], 1) << bits;
    EXPECT_GT(pixels.clipLevel[0], 1 - 1 / levels) << bits;
  }
}

TEST(CapturePixels, FullScaleOfFloatShotsClipsAtOne) {
  Set set(1.3F);
  for (Image& image : set.images)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p) image.plane(c)[p] = std::min(image.plane(c)[p], 1.0F);
  EXPECT_THAT(set.load().clipLevel, ElementsAre(1, 1));
}

TEST(CapturePixels, APileAtTheSameMaximumOfTwoShotsIsSaturation) {
  Set set(1.3F);
  for (Image& image : set.images)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p) image.plane(c)[p] = std::min(image.plane(c)[p], 0.85F);
  const CapturePixels clipped = set.load(as("float"));
  EXPECT_NEAR(clipped.clipLevel[0], 0.85F, 1e-3F);
  EXPECT_LE(clipped.clipLevel[0], 0.85F);
}

TEST(CapturePixels, FlatPatchesAndBrightHighlightsAreNotSaturation) {
  Set patches;
  patches.images[0] = Image(ImageSpec::rgb(40, 40), 0.6F);
  patches.images[1] = Image(ImageSpec::rgb(40, 40), 0.4F);
  EXPECT_THAT(patches.load().clipLevel, ElementsAre(kInfinity, kInfinity));
  Set bright(27);
  EXPECT_THAT(bright.load().clipLevel, ElementsAre(kInfinity, kInfinity));
}

TEST(CapturePixels, DamagedPixelsStayAndAreCounted) {
  Set set;
  set.images[1].plane(0)[5] = std::nanf("");
  set.images[1].plane(1)[6] = kInfinity;
  set.images[1].plane(2)[6] = -1;
  set.images[1].plane(2)[7] = -0.5F;
  set.images[1].plane(2)[8] = -0.005F;  // as noise makes it
  const CapturePixels pixels = set.load(as("float"));
  EXPECT_TRUE(std::isnan(pixels.shots[1].plane(0)[5]));
  EXPECT_EQ(pixels.shots[1].plane(1)[6], kInfinity);
  EXPECT_EQ(pixels.shots[1].plane(2)[7], -0.5F);
  EXPECT_THAT(pixels.warnings, ElementsAre(HasSubstr("two.exr: 2 pixels are not finite"),
                                           HasSubstr("two.exr: 1 pixel is negative")));
}

TEST(CapturePixels, DamageSurvivesTheConversionOfColours) {
  Set set;
  set.capture.colorSpace = "srgb";
  set.images[0].plane(0)[5] = std::nanf("");
  set.images[0].plane(1)[6] = kInfinity;
  set.images[0].plane(2)[7] = -0.5F;
  const CapturePixels pixels = set.load(as("float"));
  EXPECT_TRUE(std::isnan(pixels.shots[0].plane(0)[5]));
  EXPECT_FALSE(std::isfinite(pixels.shots[0].plane(1)[6]));
  EXPECT_LT(pixels.shots[0].plane(2)[7], 0);
}

TEST(CapturePixels, TheDarkPictureIsTakenOffExceptFromSaturatedValues) {
  Set set(0.7F, ".png");
  set.capture.dark = "dark.png";
  set.capture.ambient = "ambient.png";
  for (Image& image : set.images) image.plane(0)[9] = 1;
  writeImage(Image(ImageSpec::rgb(96, 64), 0.1F), set.folder / "dark.png", as("uint16"));
  writeImage(Image(ImageSpec::rgb(96, 64), 0.3F), set.folder / "ambient.png", as("uint16"));
  const CapturePixels pixels = set.load(as("uint16"));
  EXPECT_NEAR(pixels.shots[0].plane(1)[3000], set.images[0].plane(1)[3000] - 0.1F, 2e-5F);
  EXPECT_EQ(pixels.shots[0].plane(0)[9], 1) << "still saturated";
  ASSERT_TRUE(pixels.ambient);
  EXPECT_NEAR(pixels.ambient->plane(1)[0], 0.2F, 2e-5F);
}

TEST(CapturePixels, WhereTheDarkOrAmbientPictureIsNoNumberNothingIsKnown) {
  Set set(0.7F);
  set.capture.dark = "dark.exr";
  set.capture.ambient = "ambient.exr";
  Image dark(ImageSpec::rgb(96, 64), 0.1F), ambient(ImageSpec::rgb(96, 64), 0.3F);
  dark.plane(0)[5] = std::nanf("");
  ambient.plane(1)[6] = kInfinity;
  writeImage(dark, set.folder / "dark.exr", as("float"));
  writeImage(ambient, set.folder / "ambient.exr", as("float"));
  const CapturePixels pixels = set.load(as("float"));
  for (const Image& shot : pixels.shots) {
    EXPECT_TRUE(std::isnan(shot.plane(0)[5]));
    EXPECT_TRUE(std::isnan(shot.plane(1)[6]));
    EXPECT_TRUE(std::isfinite(shot.plane(2)[5])) << "that channel is known";
    EXPECT_TRUE(std::isfinite(shot.plane(1)[7]));
  }
  EXPECT_EQ(pixels.ambient->plane(1)[6], 0);
  writeImage(Image(ImageSpec::rgb(96, 64), std::nanf("")), set.folder / "ambient.exr", as("float"));
  EXPECT_THAT(set.error(), HasSubstr("ambient.exr: no pixel of it is a number"));
}

TEST(CapturePixels, OnePhotographUnderTwoNamesIsRefused) {
  Set set;
  (void)set.load();
  std::filesystem::copy_file(set.folder / "one.exr", set.folder / "two.exr",
                             std::filesystem::copy_options::overwrite_existing);
  set.capture.shots[0].lightColors = {Rgb(1, 0, 0), Rgb(0, 0, 1)};
  set.capture.shots[1].lightColors = {Rgb(0, 0, 1), Rgb(1, 0, 0)};
  EXPECT_THAT(set.error(), AllOf(HasSubstr("two.exr: holds the same picture as one.exr"),
                                 HasSubstr("a photograph of its own")));
  set.capture.shots[1].lightColors = set.capture.shots[0].lightColors;
  EXPECT_NO_THROW((void)loadCapturePixels(test::builtinColors(), set.capture))
      << "taken twice, for less noise";
}

TEST(CapturePixels, GreyAlphaAndLayeredShotsHaveColours) {
  Set set;
  writeImage(Image(ImageSpec{96, 64, {"Y"}, "lin_rec709"}, 0.25F), set.folder / "one.exr");
  Image layered(
      ImageSpec{96, 64, {"view.combined.R", "view.combined.G", "view.combined.B", "Z"}, "lin_rec709"}, 0.5F);
  writeImage(layered, set.folder / "two.exr");
  const CapturePixels pixels = loadCapturePixels(test::builtinColors(), set.capture);
  EXPECT_EQ(pixels.shots[0].plane(2)[100], 0.25F);
  EXPECT_EQ(pixels.shots[1].plane(1)[100], 0.5F);
  EXPECT_EQ(pixels.shots[1].channelCount(), 3);
}

TEST(CapturePixels, BadPicturesAreSaid) {
  Set set;
  (void)set.load();
  std::filesystem::remove(set.folder / "two.exr");
  EXPECT_THAT(set.error(), HasSubstr("two.exr: no such file"));
  test::writeBytes(set.folder / "two.exr", "not a picture");
  EXPECT_THAT(set.error(), HasSubstr("two.exr: is not a picture"));
  writeImage(Image(ImageSpec{96, 64, {"U", "V"}, "lin_rec709"}, 0.25F), set.folder / "two.exr");
  EXPECT_THAT(set.error(), HasSubstr("two.exr: has the channels U, V, expected R, G, B"));
  writeImage(Set::ramp(1, 48, 32), set.folder / "two.exr");
  EXPECT_THAT(set.error(), AllOf(HasSubstr("two.exr is 48 x 32 pixels"), HasSubstr("one.exr is 96 x 64")));
}

TEST(CapturePixels, DarkAndAmbientMustFitToo) {
  Set set;
  (void)set.load();
  writeImage(Set::ramp(1, 48, 32), set.folder / "dark.exr");
  set.capture.dark = "dark.exr";
  EXPECT_THAT(set.error(), HasSubstr("dark.exr is 48 x 32 pixels"));
  set.capture.dark.reset();
  set.capture.ambient = "dark.exr";
  EXPECT_THAT(set.error(), HasSubstr("dark.exr is 48 x 32 pixels"));
}

TEST(CapturePixels, AnUnknownColourSpaceIsSaidWithTheKnown) {
  Set set;
  (void)set.load();
  set.capture.colorSpace = "rec2020";
  EXPECT_THAT(set.error(), AllOf(HasSubstr("capture.json: the colour space \"rec2020\" is not known"),
                                 HasSubstr("aces2065_1")));
}

TEST(CapturePixels, OnePixelIsEnough) {
  Set set;
  for (Image& image : set.images) image = Image(ImageSpec::rgb(1, 1), 0.5F);
  const CapturePixels pixels = set.load();
  EXPECT_EQ(pixels.shots[1].plane(0)[0], 0.5F);
}

TEST(CapturePixels, ProgressCanStopTheReading) {
  Set set;
  (void)set.load();
  const std::atomic<bool> stop = true;
  EXPECT_THROW((void)loadCapturePixels(test::builtinColors(), set.capture, {{}, &stop}), Stopped);
}

}  // namespace
}  // namespace swaplight
