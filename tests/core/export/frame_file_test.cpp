#include "core/export/frame_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/color/srgb.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

Image grey(float value) {
  return Image(ImageSpec::rgb(4, 3), value);
}

float firstPixel(const std::filesystem::path& file) {
  return readImage(file).image.plane(1)[0];
}

TEST(FrameFile, AnExrIsSceneLinearAndOthersArePlainSrgb) {
  const test::TemporaryFolder folder;
  writeFrame(test::builtinColors(), grey(0.18f), folder / "a.exr", {});
  EXPECT_NEAR(firstPixel(folder / "a.exr"), 0.18f, 1e-4);
  for (const char* name : {"a.png", "a.tif", "a.jpg"}) {
    writeFrame(test::builtinColors(), grey(0.18f), folder / name, {});
    EXPECT_NEAR(firstPixel(folder / name), srgbFromLinear(0.18f), 0.006) << name;
  }
}

TEST(FrameFile, LinearIsLinearInEveryFormat) {
  const test::TemporaryFolder folder;
  FrameOptions options;
  options.linear = true;
  options.write.pixelType = "uint16";
  writeFrame(test::builtinColors(), grey(0.18f), folder / "a.png", options);
  EXPECT_NEAR(firstPixel(folder / "a.png"), 0.18f, 1e-4);
}

TEST(FrameFile, AViewIsAppliedToEveryFormat) {
  const test::TemporaryFolder folder;
  const ColorConfig& config = test::builtinColors();
  FrameOptions options;
  options.display = namedDisplay(config, {});
  Image expected = grey(0.18f);
  config.applyView(expected.span(), "lin_rec709", options.display);
  writeFrame(test::builtinColors(), grey(0.18f), folder / "a.exr", options);
  EXPECT_NEAR(firstPixel(folder / "a.exr"), expected.plane(1)[0], 1e-3);
}

TEST(FrameFile, AGreyOfAnotherSpaceIsTheSameGreyInSrgb) {
  const test::TemporaryFolder folder;
  Image frame = grey(0.18f);
  frame.setColorSpace("acescg");
  writeFrame(test::builtinColors(), std::move(frame), folder / "a.tif", {});
  EXPECT_NEAR(firstPixel(folder / "a.tif"), srgbFromLinear(0.18f), 1e-3);
}

TEST(FrameFile, WhatCannotBeIsSaidWithWhatCan) {
  const auto message = [](const char* file, const FrameOptions& options) {
    return test::inputError([&] { checkFrame(test::builtinColors(), file, options); });
  };
  FrameOptions options;
  EXPECT_THAT(message("a.webm", options), testing::HasSubstr("exr"));
  options.display.display = "Cinema";
  EXPECT_THAT(message("a.png", options),
              testing::AllOf(testing::HasSubstr("'Cinema'"),
                             testing::HasSubstr(test::builtinColors().defaultDisplay())));
  options.display = {};
  options.display.view = "Mine";
  EXPECT_THAT(message("a.png", options), testing::HasSubstr("'Mine'"));
  options.display = {"", "", "Bleached"};
  EXPECT_THAT(message("a.png", options), testing::HasSubstr("'Bleached'"));
  EXPECT_THAT(message("a.exr", options), testing::HasSubstr("name a view too"));
  options.linear = true;
  EXPECT_THAT(message("a.png", options), testing::HasSubstr("either linear"));
}

}  // namespace
}  // namespace swaplight
