#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/capture/capture_pixels.h"
#include "core/capture/mosaic_saturation.h"
#include "core/image/io/image_io.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_dng.h"

namespace swaplight {
namespace {

using test::TemporaryFolder;
using ::testing::HasSubstr;

/// Red 0.8, green 0.4, blue 0.1 of full scale on the left; saturated red, green 0.5, blue 0.25 on the right.
std::string twoPatches() {
  return test::tinyDng(128, 64, [](int x, int y) {
    const bool red = x % 2 == 0 && y % 2 == 0;
    const bool blue = x % 2 == 1 && y % 2 == 1;
    const double left = red ? 0.8 : (blue ? 0.1 : 0.4);
    const double right = red ? 1.2 : (blue ? 0.25 : 0.5);
    return static_cast<uint16_t>(std::lround(512 + (16383 - 512) * (x < 64 ? left : std::min(right, 1.0))));
  });
}

TEST(CameraRaw, IsDevelopedToWhatTheSensorCounted) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "shot.dng", twoPatches());
  const ImageFile file = readImage(folder / "shot.dng");
  EXPECT_EQ(file.info.format, "raw");
  ASSERT_EQ(file.image.channelCount(), 3);
  ASSERT_EQ(file.image.width(), 128);
  const ImageView view = file.image.view();
  const float left[3] = {0.8F, 0.4F, 0.1F};
  const float right[3] = {1.0F, 0.5F, 0.25F};
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(view.at(c, 32, 32), left[c], 2e-4F) << "no gamma, no white balance, no brightening";
    EXPECT_NEAR(view.at(c, 96, 32), right[c], 2e-4F) << "saturation of one channel leaves the others";
  }
}

TEST(CameraRaw, ShotsOfACaptureAreLinearAndClipAtFullScale) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "one.dng", twoPatches());
  Capture capture;
  capture.folder = folder.path();
  capture.colorSpace = "srgb";
  capture.lights = {{"key", Role::Key, {}}};
  capture.shots = {{"one.dng", {Rgb(1)}, {}, 0, false, {}}};
  const CapturePixels pixels = loadCapturePixels(test::builtinColors(), capture);
  EXPECT_NEAR(pixels.shots[0].view().at(1, 32, 32), 0.4F, 2e-4F);
  EXPECT_TRUE(pixels.rounding.empty());
  EXPECT_GE(pixels.shots[0].view().at(0, 96, 32), pixels.clipLevel[0]);
  EXPECT_LT(pixels.shots[0].view().at(1, 96, 32), pixels.clipLevel[0]);
  ASSERT_EQ(pixels.warnings.size(), 1U);
  EXPECT_THAT(pixels.warnings[0], HasSubstr("camera raw is linear"));
}

TEST(CameraRaw, WhatIsInterpolatedFromASaturatedPixelCountsAsSaturated) {
  Image image(ImageSpec::rgb(8, 6), 0.5F);
  image.span().at(1, 4, 3) = 1;
  spreadSaturation(image, 0.999F);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x) {
      const bool beside = std::abs(x - 4) <= 1 && std::abs(y - 3) <= 1;
      EXPECT_EQ(image.view().at(1, x, y), beside ? 1.F : 0.5F);
      EXPECT_EQ(image.view().at(0, x, y), 0.5F) << "the other channels are as they are";
    }
}

}  // namespace
}  // namespace swaplight
