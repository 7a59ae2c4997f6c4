#include "core/capture/capture_frame.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/capture.h"
#include "core/image/cropped_image.h"

namespace swaplight {
namespace {

Image ramp(int width, int height) {
  Image image(ImageSpec::rgb(width, height));
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) image.span().at(c, x, y) = static_cast<float>(x + 100 * y + c);
  return image;
}

TEST(CaptureFrame, ACropIsThoseVeryPixels) {
  const Image image = ramp(20, 12);
  const Image part = croppedImage(image, {5, 3, 8, 4}, "shot");
  EXPECT_EQ(part.width(), 8);
  EXPECT_EQ(part.height(), 4);
  EXPECT_EQ(part.view().at(1, 0, 0), image.view().at(1, 5, 3));
  EXPECT_EQ(part.view().at(2, 7, 3), image.view().at(2, 12, 6));
  EXPECT_THROW((void)croppedImage(image, {15, 3, 8, 4}, "shot"), InputError);
}

TEST(CaptureFrame, AScaledPixelIsTheMeanOfThoseThatItStandsFor) {
  const Image half = scaledImage(ramp(20, 12), 0.5, std::numeric_limits<float>::infinity());
  EXPECT_EQ(half.width(), 10);
  EXPECT_EQ(half.height(), 6);
  EXPECT_NEAR(half.view().at(0, 3, 2), (6 + 400 + 7 + 400 + 6 + 500 + 7 + 500) / 4.0F, 1e-3);
}

TEST(CaptureFrame, WhatIsSaturatedStaysSoWhenItIsAveraged) {
  Image image(ImageSpec::rgb(8, 8), 0.25F);
  image.span().at(0, 5, 5) = 1;
  const Image half = scaledImage(image, 0.5, 0.99F);
  EXPECT_FLOAT_EQ(half.view().at(0, 2, 2), 0.99F);
  EXPECT_FLOAT_EQ(half.view().at(1, 2, 2), 0.25F);
  EXPECT_FLOAT_EQ(half.view().at(0, 1, 1), 0.25F);
}

TEST(CaptureFrame, IsKeptInTheManifest) {
  const Json json = {{"lights", {{{"name", "key"}}}},
                     {"color_space", "lin_rec709"},
                     {"crop", {10, 20, 300, 200}},
                     {"scale", 0.5},
                     {"shots", {{{"image", "a.exr"}, {"light_colors", {{1, 1, 1}}}}}}};
  const Capture capture = captureFromJson(json, ".");
  EXPECT_EQ(capture.frame.crop, (PixelRect{10, 20, 300, 200}));
  EXPECT_EQ(capture.frame.scale, 0.5);
  const Json back = jsonFromCapture(capture);
  EXPECT_EQ(back.at("crop"), json.at("crop"));
  EXPECT_EQ(back.at("scale"), json.at("scale"));
  Json wrong = json;
  wrong["crop"] = {10, 20, 300};
  EXPECT_THROW((void)captureFromJson(wrong, "."), InputError);
  wrong["crop"] = {10, 20, 0, 200};
  EXPECT_THROW((void)captureFromJson(wrong, "."), InputError);
  wrong = json;
  wrong["scale"] = 2;
  EXPECT_THROW((void)captureFromJson(wrong, "."), InputError);
}

TEST(CaptureFrame, IsReadFromTheCommandLine) {
  EXPECT_EQ(cropFromText("1,2,30,40"), (PixelRect{1, 2, 30, 40}));
  for (const char* text : {"1,2,30", "1,2,30,40,5", "a", "-1,2,3,4", "1,2,0,4"})
    EXPECT_THROW((void)cropFromText(text), InputError) << text;
  EXPECT_THROW((void)checkedScale(0), InputError);
  EXPECT_THROW((void)checkedScale(1.5), InputError);
}

}  // namespace
}  // namespace swaplight
