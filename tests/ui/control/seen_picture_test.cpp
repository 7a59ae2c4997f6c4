#include "ui/camera/seen_picture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace swaplight {
namespace {

/// Rises by one a pixel of the frame, in both directions.
void fillRamp(SeenPicture& picture, float scale) {
  picture.width = 101;
  picture.height = 60;
  picture.scale = scale;
  picture.image = Image(
      ImageSpec::rgb(static_cast<int>(std::ceil(101 * scale)), static_cast<int>(std::ceil(60 * scale))));
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < picture.image.height(); ++y)
      for (int x = 0; x < picture.image.width(); ++x)
        picture.image.span().at(c, x, y) =
            (static_cast<float>(x) + 0.5F + static_cast<float>(y) + 0.5F) / scale;
  picture.pyramid.emplace(picture.image.view());
}

TEST(SeenPicture, ADraftThatIsEnlargedIsWhereTheFrameIs) {
  SeenPicture picture;
  fillRamp(picture, 0.26F);
  picture.colorSpace = "lin_rec709";
  enlarge(picture);
  ASSERT_EQ(picture.image.width(), 101);
  ASSERT_EQ(picture.image.height(), 60);
  EXPECT_EQ(picture.pyramid->width(), 101);
  EXPECT_EQ(picture.scale, 1);
  for (int y = 4; y < 56; ++y)  // at the edge nothing lies beyond the last pixel of the draft
    for (int x = 4; x < 97; ++x)
      ASSERT_NEAR(picture.image.view().at(1, x, y), static_cast<float>(x + y + 1), 0.02F) << x << ' ' << y;
}

TEST(SeenPicture, AnExactPictureAndNoneStayAsTheyAre) {
  SeenPicture picture;
  enlarge(picture);
  EXPECT_TRUE(picture.image.empty());
  fillRamp(picture, 1);
  const float* pixels = picture.image.plane(0);
  enlarge(picture);
  EXPECT_EQ(picture.image.plane(0), pixels);
}

}  // namespace
}  // namespace swaplight
