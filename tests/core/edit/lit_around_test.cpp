#include "core/edit/pool/lit_around.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace swaplight {
namespace {

constexpr int kWidth = 320, kHeight = 180;

std::shared_ptr<const Image> around(const std::function<bool(int, int)>& isLit) {
  Image visibility(ImageSpec{kWidth, kHeight, {"Y"}, "data"});
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) visibility.span().at(0, x, y) = isLit(x, y) ? 1 : 0;
  return litAround(visibility);
}

float at(const Image& image, int x, int y) {
  return image.view().at(0, x, y);
}

TEST(LitAround, IsAllOfAShadowAmongLitSurfaces) {
  const auto bar = around([](int x, int y) { return x < 140 || x > 180 || y < 20; });
  EXPECT_GT(at(*bar, 160, 90), .95F);
  EXPECT_GT(at(*bar, 10, 90), .95F);  // lit itself
}

TEST(LitAround, IsNothingBeyondAllThatIsLit) {
  const auto side = around([](int x, int) { return x < 80; });
  for (const int x : {90, 200, 310}) EXPECT_LT(at(*side, x, 90), .05F) << x;
  // A pool with a bar's shadow in it.
  const auto pool = around([](int x, int y) {
    const bool inside = (x - 90) * (x - 90) + 4 * (y - 120) * (y - 120) < 70 * 70;
    return inside && (x < 80 || x > 95);
  });
  EXPECT_GT(at(*pool, 88, 120), .95F);
  for (const auto& [x, y] : {std::pair{250, 120}, {90, 20}, {170, 170}, {5, 5}})
    EXPECT_LT(at(*pool, x, y), .05F) << x << ", " << y;
}

TEST(LitAround, TakesWhatLiesBeyondThePictureForWhatMostOfItsBorderIs) {
  const auto corner = around([](int x, int y) { return x > 100 || y < 90; });
  for (const auto& [x, y] : {std::pair{0, kHeight - 1}, {50, 130}, {95, 100}})
    EXPECT_GT(at(*corner, x, y), .95F) << x << ", " << y;
}

TEST(LitAround, TellsEvenPicturesAndThinOnes) {
  const auto lit = around([](int, int) { return true; }), dark = around([](int, int) { return false; });
  for (const int x : {0, 160, kWidth - 1}) {
    EXPECT_EQ(at(*lit, x, 90), 1);
    EXPECT_EQ(at(*dark, x, 90), 0);
  }
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 50}, {700, 1}, {2, 3}}) {
    Image thin(ImageSpec{width, height, {"Y"}, "data"});
    std::fill_n(thin.plane(0), thin.pixelCount(), 0.F);
    EXPECT_EQ(litAround(thin)->view().at(0, width - 1, height - 1), 0);
  }
}

}  // namespace
}  // namespace swaplight
