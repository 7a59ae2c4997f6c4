#include "core/measure/delta_e.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/color/srgb.h"
#include "core/measure/lab.h"

namespace swaplight {
namespace {

struct PublishedPair {
  Lab x, y;
  double deltaE;
};

// Sharma, Wu, Dalal 2005, table 1.
constexpr PublishedPair kPublished[] = {
    {{50.0000, 2.6772, -79.7751}, {50.0000, 0.0000, -82.7485}, 2.0425},
    {{50.0000, 3.1571, -77.2803}, {50.0000, 0.0000, -82.7485}, 2.8615},
    {{50.0000, 2.8361, -74.0200}, {50.0000, 0.0000, -82.7485}, 3.4412},
    {{50.0000, -1.3802, -84.2814}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -1.1848, -84.8006}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -0.9009, -85.5211}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, 0.0000, 0.0000}, {50.0000, -1.0000, 2.0000}, 2.3669},
    {{50.0000, -1.0000, 2.0000}, {50.0000, 0.0000, 0.0000}, 2.3669},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0009}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0010}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0011}, 7.2195},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0012}, 7.2195},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0009, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0010, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0011, -2.4900}, 4.7461},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 0.0000, -2.5000}, 4.3065},
    {{50.0000, 2.5000, 0.0000}, {73.0000, 25.0000, -18.0000}, 27.1492},
    {{50.0000, 2.5000, 0.0000}, {61.0000, -5.0000, 29.0000}, 22.8977},
    {{50.0000, 2.5000, 0.0000}, {56.0000, -27.0000, -3.0000}, 31.9030},
    {{50.0000, 2.5000, 0.0000}, {58.0000, 24.0000, 15.0000}, 19.4535},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.1736, 0.5854}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2972, 0.0000}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 1.8634, 0.5757}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2592, 0.3350}, 1.0000},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
    {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
};
static_assert(std::size(kPublished) == 34);

TEST(DeltaE, WeightsDivideEachOfTheThreeDifferences) {
  const DeltaEWeights lightnessAFifth{5, 1, 1};
  EXPECT_NEAR(deltaE2000({60, 0, 0}, {50, 0, 0}, lightnessAFifth), deltaE2000({60, 0, 0}, {50, 0, 0}) / 5,
              1e-9);
  EXPECT_NEAR(deltaE2000({50, 20, 0}, {50, 10, 0}, lightnessAFifth), deltaE2000({50, 20, 0}, {50, 10, 0}),
              1e-9);
  EXPECT_NEAR(deltaE2000({50, 20, 0}, {50, 10, 0}, {1, 4, 1}), deltaE2000({50, 20, 0}, {50, 10, 0}) / 4,
              1e-9);
  // Red, where hue and chroma do not act on each other: of one chroma, so that hue alone differs.
  const Lab x{50, 30, 1}, y{50, 30, -1};
  EXPECT_NEAR(deltaE2000(x, y, {1, 1, 2}), deltaE2000(x, y) / 2, 1e-9);
}

TEST(DeltaE, EqualsAllPublishedPairs) {
  for (size_t i = 0; i < std::size(kPublished); ++i)
    EXPECT_NEAR(deltaE2000(kPublished[i].x, kPublished[i].y), kPublished[i].deltaE, 1e-4) << "pair " << i + 1;
}

TEST(DeltaE, IsSymmetricAndZeroForEqualColours) {
  for (const PublishedPair& pair : kPublished) {
    EXPECT_NEAR(deltaE2000(pair.y, pair.x), deltaE2000(pair.x, pair.y), 1e-9);
    EXPECT_EQ(deltaE2000(pair.x, pair.x), 0);
  }
}

TEST(DeltaE, PictureEqualsPixelByPixelAndMarksWhatIsNotFinite) {
  Image test(ImageSpec::rgb(37, 19));
  Image reference(ImageSpec::rgb(37, 19));
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < test.pixelCount(); ++p) {
      test.plane(c)[p] = static_cast<float>((p * 7 + static_cast<size_t>(c) * 31) % 101) / 60.f;
      reference.plane(c)[p] = static_cast<float>((p * 5 + static_cast<size_t>(c) * 17) % 97) / 60.f;
    }
  test.plane(1)[40] = NAN;
  reference.plane(2)[41] = INFINITY;
  Image out(ImageSpec{37, 19, {"de"}, "data"});
  deltaE2000(test.view(), reference.view(), .5f, out.span());
  for (size_t p = 0; p < test.pixelCount(); ++p) {
    if (p == 40 || p == 41) {
      EXPECT_TRUE(std::isnan(out.plane(0)[p]));
      continue;
    }
    const auto labOf = [&](const Image& image) {
      return labFromLinearRec709(.5 * image.plane(0)[p], .5 * image.plane(1)[p], .5 * image.plane(2)[p]);
    };
    EXPECT_NEAR(out.plane(0)[p], deltaE2000(labOf(test), labOf(reference)), 1e-4);
  }
}

// Published by Lindbloom's calculator for sRGB primaries and D65, to a rounding of its matrices.
TEST(Lab, MatchesTheKnownLabOfSrgbPrimaries) {
  const Lab white = labFromLinearRec709(1, 1, 1);
  EXPECT_NEAR(white.L, 100, 1e-4);
  EXPECT_NEAR(white.a, 0, 1e-3);
  EXPECT_NEAR(white.b, 0, 1e-3);
  const Lab red = labFromLinearRec709(1, 0, 0);
  EXPECT_NEAR(red.L, 53.24, .02);
  EXPECT_NEAR(red.a, 80.09, .05);
  EXPECT_NEAR(red.b, 67.20, .05);
  const Lab blue = labFromLinearRec709(-1, 0, 7);  // clipped to 0..1
  EXPECT_NEAR(blue.L, 32.30, .02);
  EXPECT_NEAR(blue.a, 79.19, .05);
  EXPECT_NEAR(blue.b, -107.86, .05);
  EXPECT_EQ(labFromLinearRec709(0, 0, 0).L, 0);
}

TEST(Lab, TheSrgbCurveKnowsItsPublishedPoints) {
  EXPECT_NEAR(linearFromSrgb(.04045), .0031308, 1e-6);
  EXPECT_NEAR(linearFromSrgb(.5), .214041, 1e-6);
  EXPECT_EQ(linearFromSrgb(0.0), 0);
  EXPECT_EQ(linearFromSrgb(1.0), 1);
}

}  // namespace
}  // namespace swaplight
