#include "core/relight/relative_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/base/json.h"
#include "core/relight/relight.h"

namespace swaplight {
namespace {

constexpr int kWidth = 24, kHeight = 16;

/// Two lights on one grey: from the left and from the right, and a pixel that neither reaches.
SolvedSet crossLit(int width = kWidth, int height = kHeight) {
  SolvedSet set;
  for (int light = 0; light < 2; ++light) {
    Image image(ImageSpec::rgb(width, height));
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const float across = (static_cast<float>(x) + 0.5F) / static_cast<float>(width);
          image.span().at(c, x, y) = x + y == 0 ? 0 : 0.4F * (light == 0 ? 1 - across : across);
        }
    set.contributions.push_back(std::move(image));
    set.capture.lights.push_back({light == 0 ? "left" : "right", Role::Other, Json::object()});
  }
  updateBeta(set);
  return set;
}

TEST(RelativeLight, UnitWhiteIsOneEverywhere) {
  const Image light = relativeLight(crossLit(), std::vector<Rgb>{Rgb(1), Rgb(1)}, 1);
  ASSERT_EQ(light.width(), kWidth);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < light.pixelCount(); ++p) EXPECT_NEAR(light.plane(c)[p], 1, 1e-6);
}

TEST(RelativeLight, IsTheProportionTimesTheFactor) {
  const SolvedSet set = crossLit();
  const Rgb left(2, 0.5F, 0.25F), right(0, 1, 4);
  const Image light = relativeLight(set, std::vector<Rgb>{left, right}, 1);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 1; p < light.pixelCount(); ++p)
      EXPECT_NEAR(light.plane(c)[p], left[c] * set.beta.plane(0)[p] + right[c] * set.beta.plane(1)[p], 0.004);
}

TEST(RelativeLight, TimesThePictureAtUnitWhiteIsTheFrame) {
  const SolvedSet set = crossLit();
  const std::vector<Rgb> factors{Rgb(3, 0.1F, 1), Rgb(0.2F, 2, 1)};
  const Image light = relativeLight(set, factors, 1), frame = relight(set, factors),
              unit = sumAtUnitWhite(set);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < light.pixelCount(); ++p)
      EXPECT_NEAR(light.plane(c)[p] * unit.plane(c)[p], frame.plane(c)[p], 0.002F * 3);
}

TEST(RelativeLight, WhereNothingIsLitItIsTheMeanOfTheFrame) {
  const Image light = relativeLight(crossLit(), std::vector<Rgb>{Rgb(2), Rgb(2)}, 1);
  EXPECT_NEAR(light.plane(0)[0], 2, 1e-5);
  SolvedSet dark = crossLit();
  for (Image& picture : dark.contributions) picture = Image(picture.spec(), 0);
  const Image none = relativeLight(dark, std::vector<Rgb>{Rgb(2), Rgb(2)}, 1);
  for (size_t p = 0; p < none.pixelCount(); ++p) EXPECT_EQ(none.plane(1)[p], 1);
}

TEST(RelativeLight, AmbientIsPartOfBoth) {
  SolvedSet set = crossLit();
  set.ambient = sumAtUnitWhite(set);
  const Image light = relativeLight(set, std::vector<Rgb>{Rgb(0), Rgb(0)}, 3);
  EXPECT_NEAR(light.plane(2)[30], 1.5, 1e-5);
}

TEST(RelativeLight, LargeFramesAreShrunk) {
  const Image light =
      relativeLight(crossLit(3 * kRelativeLightSide, 30), std::vector<Rgb>{Rgb(2), Rgb(0)}, 1);
  EXPECT_EQ(light.width(), kRelativeLightSide);
  EXPECT_EQ(light.height(), 10);
  EXPECT_NEAR(light.plane(0)[light.pixelCount() - kRelativeLightSide], 2, 0.01);
}

TEST(RelativeLight, WantsAFactorALight) {
  EXPECT_THROW(static_cast<void>(relativeLight(crossLit(), std::vector<Rgb>{Rgb(1)}, 1)), std::logic_error);
}

}  // namespace
}  // namespace swaplight
