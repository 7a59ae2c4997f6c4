#include "core/image/small_picture.h"

#include <gtest/gtest.h>

namespace swaplight {
namespace {

/// Thirds of red, green and blue, side by side.
SmallPicture thirds(int width, int height) {
  SmallPicture picture{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 4; ++c) picture.rgba.push_back(c == 3 || c == 3 * x / width ? 255 : 0);
  return picture;
}

TEST(SmallPicture, FillsAFrameOfItsOwnShapeWithAllOfIt) {
  const SmallPicture half = filling(thirds(60, 20), 30, 10);
  ASSERT_EQ(half.rgba.size(), 4U * 30 * 10);
  EXPECT_EQ(half.rgba, thirds(30, 10).rgba);
}

TEST(SmallPicture, FillsANarrowerFrameWithItsMiddle) {
  const SmallPicture middle = filling(thirds(60, 20), 20, 20);
  for (size_t p = 0; p < 400; ++p) {
    EXPECT_EQ(middle.rgba[4 * p], 0);
    EXPECT_EQ(middle.rgba[4 * p + 1], 255);
    EXPECT_EQ(middle.rgba[4 * p + 2], 0);
  }
}

TEST(SmallPicture, IsMadeLargerAndSmallerThanAPixel) {
  EXPECT_EQ(filling(thirds(3, 1), 300, 200).rgba.size(), 4U * 300 * 200);
  EXPECT_EQ(filling(thirds(300, 200), 1, 1).rgba.size(), 4U);
  EXPECT_TRUE(filling({}, 10, 10).empty());
}

}  // namespace
}  // namespace swaplight
