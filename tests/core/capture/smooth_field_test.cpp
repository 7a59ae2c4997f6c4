#include "core/capture/smooth_field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using testing::HasSubstr;

constexpr int kWide = 150, kHigh = 100;

double across(double pixel, int size) {
  return (2 * pixel + 1) / size - 1;
}

/// `level(c, x, y)`, x and y from -1 to 1, with 2 % noise.
template <typename Level>
Image flatPicture(const Level& level) {
  std::mt19937 random(3);
  std::normal_distribution<double> gauss;
  Image image(ImageSpec::rgb(kWide, kHigh));
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < kHigh; ++y)
      for (int x = 0; x < kWide; ++x)
        image.span().at(c, x, y) =
            static_cast<float>(level(c, across(x, kWide), across(y, kHigh)) * (1 + .02 * gauss(random)));
  return image;
}

/// A gelled lamp whose colour drifts by 10 % over the field, brighter at the left.
double drifting(int c, double x, double y) {
  const double gel[] = {.5, .3, .05};
  const double drift[] = {1 + .1 * x, 1, 1 - .1 * x * y};
  return gel[c] * drift[c] * (1 - .4 * x);
}

double largestError(const SmoothField& field, int c, double (*truth)(double, double)) {
  double largest = 0;
  for (double y = -.95; y < 1; y += .19)
    for (double x = -.95; x < 1; x += .19)
      largest = std::max(largest, std::abs(field.at(c, x, y) / truth(x, y) - 1));
  return largest;
}

TEST(SmoothField, OfAPartIsThatPartOfIt) {
  const SmoothField field = colorFieldOf(flatPicture(drifting), "flat").field;
  const PixelRect part{40, 10, 60, 80}, inner{5, 20, 30, 25};
  const SmoothField of = field.within(part, kWide, kHigh),
                    ofInner = of.within(inner, part.width, part.height);
  std::vector<float> whole(kWide), found(60);
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < 80; ++y) {
      field.row(c, 10 + y, kWide, kHigh, whole.data());
      of.row(c, y, 60, 80, found.data());
      for (int x = 0; x < 60; ++x)
        ASSERT_NEAR(found[size_t(x)], whole[size_t(40 + x)], 1e-6) << x << " " << y;
    }
  EXPECT_NEAR(ofInner.at(0, -1, 1), field.at(0, 2 * 45 / 150.0 - 1, 2 * 55 / 100.0 - 1), 1e-9);
}

TEST(ColorField, IsTheLampsColourWithoutItsLevel) {
  const FieldFit fit = colorFieldOf(flatPicture(drifting), "flat");
  // The ratio of two channels has no level in it.
  for (double y = -.9; y < 1; y += .3)
    for (double x = -.9; x < 1; x += .3) {
      const double found = fit.field.at(0, x, y) / fit.field.at(2, x, y);
      EXPECT_NEAR(found / ((1 + .1 * x) / (1 - .1 * x * y)), 1, .01) << x << " " << y;
    }
  EXPECT_LT(fit.misfit, .01);
}

TEST(ColorField, DoesNotSeeShadowsAndThingsInACorner) {
  const FieldFit fit = colorFieldOf(flatPicture([](int c, double x, double y) {
                                      const double shadow = std::abs(x - .2) < .1 ? .4 : 1;
                                      const double thing = x > .75 && y > .75 && c == 1 ? 2 : 1;
                                      return .4 * shadow * thing;
                                    }),
                                    "flat");
  for (int c = 0; c < 3; ++c) EXPECT_LT(largestError(fit.field, c, [](double, double) { return 1.0; }), .01);
}

TEST(ColorField, IsOneInAChannelThatIsTooDark) {
  const FieldFit fit = colorFieldOf(
      flatPicture([](int c, double x, double) { return c == 2 ? 1e-4 : .5 * (1 + .05 * c * x); }), "flat");
  EXPECT_EQ(fit.field.at(2, .7, -.3), 1);
  EXPECT_NE(fit.field.at(1, .7, -.3), 1);
}

TEST(LevelField, HoldsCosinesToTheFourth) {
  const FieldFit fit = levelFieldOf(
      flatPicture([](int, double x, double y) { return .6 * std::pow(1 + .36 * x * x + .16 * y * y, -2); }),
      "flat");
  for (int c = 0; c < 3; ++c)
    EXPECT_LT(largestError(fit.field, c,
                           [](double x, double y) { return std::pow(1 + .36 * x * x + .16 * y * y, -2); }),
              .01);
}

TEST(SmoothField, RowsAreItsValues) {
  const FieldFit fit = levelFieldOf(flatPicture(drifting), "flat");
  std::vector<float> row(70);
  for (const int y : {0, 17, 39}) {
    fit.field.row(1, y, 70, 40, row.data());
    for (int x = 0; x < 70; x += 3)
      EXPECT_NEAR(row[size_t(x)], fit.field.at(1, across(x, 70), across(y, 40)), 1e-6);
  }
  Image picture(ImageSpec::rgb(70, 40), .5F);
  fit.field.takeFrom(picture);
  fit.field.row(1, 17, 70, 40, row.data());
  EXPECT_FLOAT_EQ(picture.view().at(1, 33, 17), .5F / row[33]);
}

TEST(SmoothField, SaysWhatIsNoFlatPicture) {
  EXPECT_GT(colorFieldOf(flatPicture([](int c, double x, double y) {
                           return .3 * (1 + .5 * std::sin(9 * x + 4 * c) * std::cos(7 * y));
                         }),
                         "flat")
                .misfit,
            .02);
  for (const double level : {0.0, double(NAN), -1.0})
    EXPECT_THAT(inputError([&] {
                  (void)levelFieldOf(flatPicture([&](int, double, double) { return level; }), "black.png");
                }),
                HasSubstr("black.png: most of it is clipped, black or broken"));
}

}  // namespace
}  // namespace swaplight
