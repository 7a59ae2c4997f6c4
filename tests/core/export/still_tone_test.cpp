#include "core/export/still_tone.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Sixteen stops from left to right, warm.
Image highContrast() {
  Image image(ImageSpec::rgb(96, 64));
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 96; ++x)
      for (int c = 0; c < 3; ++c)
        image.span().at(c, x, y) =
            std::exp2(static_cast<float>(x) / 6 - 10) * (1 - 0.2F * static_cast<float>(c));
  return image;
}

TEST(StillTone, BringsSixteenStopsIntoWhatADisplayShows) {
  for (const char* text : {"drago", "drago:bias=0.7,saturation=1.2", "mantiuk", "mantiuk:scale=0.9",
                           "reinhard", "reinhard:intensity=1,adapt=0.5,color_adapt=0.5"}) {
    Image image = highContrast();
    applyStillTone(image.span(), stillToneFromText(text));
    double sum = 0;
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p) {
        ASSERT_TRUE(image.plane(c)[p] >= 0 && image.plane(c)[p] <= 1) << text;
        sum += image.plane(c)[p];
      }
    const double mean = sum / static_cast<double>(3 * image.pixelCount());
    EXPECT_GT(mean, 0.05) << text;
    EXPECT_LT(mean, 0.95) << text;
    EXPECT_GT(image.span().at(1, 90, 32), image.span().at(1, 20, 32)) << text << ": bright stays brighter";
  }
}

TEST(StillTone, PixelsThatAreNotFiniteSpoilNothing) {
  for (const char* text : {"drago", "mantiuk", "reinhard"}) {
    Image image = highContrast();
    image.plane(0)[5] = std::numeric_limits<float>::quiet_NaN();
    image.plane(1)[6] = std::numeric_limits<float>::infinity();
    image.plane(2)[7] = -1;
    applyStillTone(image.span(), stillToneFromText(text));
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p)
        ASSERT_TRUE(image.plane(c)[p] >= 0 && image.plane(c)[p] <= 1) << text;
  }
}

TEST(StillTone, WhatIsNotKnownIsSaidWithWhatIs) {
  const auto message = [](const char* text) {
    return test::inputError([&] { static_cast<void>(stillToneFromText(text)); });
  };
  EXPECT_THAT(message("aces"), AllOf(HasSubstr("'aces'"), HasSubstr("drago, mantiuk, reinhard")));
  EXPECT_THAT(message("drago:scale=1"), AllOf(HasSubstr("'scale'"), HasSubstr("bias, saturation")));
  EXPECT_THAT(message("drago:bias=2"), HasSubstr("from 0.5 to 1"));
  EXPECT_THAT(message("mantiuk:scale"), HasSubstr("scale=0.7"));
}

}  // namespace
}  // namespace swaplight
