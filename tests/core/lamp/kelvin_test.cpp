#include "core/lamp/kelvin.h"

#include <gtest/gtest.h>

#include "core/color/planck.h"

namespace swaplight {
namespace {

// Published anchors. A (2856 K): CIE 015. D50, D55, D65, D75: CIE 015 table T.3; the nominal temperatures
// times 1.4388 / 1.4380.

TEST(Kelvin, IlluminantAIsTheBlackBodyOf2856Kelvin) {
  const Chromaticity a = whiteXy(2855.5);
  EXPECT_NEAR(a.x, 0.44757, 5e-5);
  EXPECT_NEAR(a.y, 0.40745, 5e-5);
}

TEST(Kelvin, BlackBodiesMatchThePublishedLocus) {
  // Robertson's table (Wyszecki and Stiles, 1982): u, v at so many mired.
  const struct {
    double mired, u, v;
  } anchors[] = {{50, 0.18388, 0.27709},  {100, 0.19032, 0.29326}, {200, 0.21142, 0.32312},
                 {300, 0.24010, 0.34308}, {400, 0.27218, 0.35407}, {600, 0.33724, 0.36051}};
  for (const auto& anchor : anchors) {
    const Uv uv = uvFromXy(planckianXy(1e6 / anchor.mired));
    EXPECT_NEAR(uv.u, anchor.u, 5e-5) << anchor.mired;
    EXPECT_NEAR(uv.v, anchor.v, 5e-5) << anchor.mired;
  }
}

TEST(Kelvin, DaylightMatchesThePublishedIlluminants) {
  const struct {
    double kelvin, x, y;
  } anchors[] = {
      {5003, 0.3457, 0.3585}, {5503, 0.3325, 0.3474}, {6504, 0.3127, 0.3290}, {7504, 0.2990, 0.3149}};
  for (const auto& anchor : anchors) {
    const Chromaticity xy = whiteXy(anchor.kelvin);
    EXPECT_NEAR(xy.x, anchor.x, 2e-4) << anchor.kelvin;
    EXPECT_NEAR(xy.y, anchor.y, 2e-4) << anchor.kelvin;
  }
}

TEST(Kelvin, TheWhiteOfD65IsUnitWhiteInRec709) {
  const Rgb white = rec709FromXy(whiteXy(kD65Kelvin));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1, 1e-3);
}

TEST(Kelvin, EveryTemperatureHasLuminanceOneAndNoNegativeChannel) {
  float last = 1e9f;
  for (double kelvin = kLowestKelvin; kelvin <= kHighestKelvin; kelvin *= 1.01) {
    const Rgb rgb = rec709FromXy(whiteXy(kelvin));
    EXPECT_NEAR(luminance(rgb), 1, 1e-6);
    EXPECT_GE(rgb.x, 0);
    EXPECT_GE(rgb.y, 0);
    EXPECT_GE(rgb.z, 0);
    EXPECT_LT(rgb.x, last) << "red falls as the temperature rises, also where the loci meet: " << kelvin;
    last = rgb.x;
  }
}

TEST(Kelvin, TheLocusHasNoStepWhereItsPartsMeet) {
  for (const double kelvin : {4000.0, 5000.0, 7000.0, 25000.0}) {
    const Uv below = uvFromXy(whiteXy(kelvin * (1 - 1e-9)));
    const Uv above = uvFromXy(whiteXy(kelvin * (1 + 1e-9)));
    EXPECT_NEAR(below.u, above.u, 2e-5) << kelvin;
    EXPECT_NEAR(below.v, above.v, 2e-5) << kelvin;
  }
}

TEST(Kelvin, TemperatureAndDuvComeBack) {
  for (double kelvin = 1500; kelvin <= 20000; kelvin *= 1.3)
    for (const double duv : {-0.03, -0.005, 0.0, 0.01, 0.03}) {
      const double offset =
          correlatedTemperature(whiteXy(kelvin)).duv;  // daylight lies beside the black body
      const CorrelatedTemperature found = correlatedTemperature(whiteXy(kelvin, duv));
      EXPECT_NEAR(found.duv, duv + offset, 2e-4) << kelvin;
      if (kelvin < 4000) {
        EXPECT_NEAR(found.kelvin, kelvin, 0.004 * kelvin) << duv;
      }
    }
}

TEST(Kelvin, ThePublishedTemperatureOfD65IsFound) {
  // ANSI C78.377 and Ohno (2014): D65 has 6503 K and Duv +0.0032.
  const CorrelatedTemperature d65 = correlatedTemperature(kD65);
  EXPECT_NEAR(d65.kelvin, 6503, 5);
  EXPECT_NEAR(d65.duv, 0.0032, 1e-4);
}

TEST(Kelvin, GreenLiesAboveTheLocus) {
  EXPECT_GT(rec709FromXy(whiteXy(3200, kFullGreenDuv)).y, rec709FromXy(whiteXy(3200)).y);
  EXPECT_LT(rec709FromXy(whiteXy(5600, -kFullGreenDuv)).y, rec709FromXy(whiteXy(5600)).y);
}

TEST(Chromaticity, ComesBackThroughRec709AndUv) {
  const Chromaticity xy{0.36, 0.37};
  const Chromaticity again = xyFromRec709(rec709FromXy(xy));
  EXPECT_NEAR(again.x, xy.x, 1e-6);
  EXPECT_NEAR(again.y, xy.y, 1e-6);
  const Chromaticity fromUv = xyFromUv(uvFromXy(xy));
  EXPECT_NEAR(fromUv.x, xy.x, 1e-12);
  EXPECT_NEAR(fromUv.y, xy.y, 1e-12);
  EXPECT_NEAR(luminance({0, 1, 0}), 0.7152, 1e-4);
}

}  // namespace
}  // namespace swaplight
