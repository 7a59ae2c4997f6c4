#include "core/ocio/camera_spaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/ocio/color_config.h"
#include "core/ocio/convert_color.h"

namespace swaplight {
namespace {

float linearGrey(const ColorConfig& config, const char* space, double code) {
  return convertColor(config, Rgb(float(code)), space, "lin_rec709").g;
}

TEST(CameraSpaces, EveryOneIsKnownByNameAndAliasAndKeepsGreyGrey) {
  const ColorConfig config("");
  for (const CameraSpace& space : cameraSpaces()) {
    for (const char* name : {space.name, space.alias}) config.checkColorSpace(name);
    float before = -1;
    for (int code = 0; code <= 20; ++code) {
      const Rgb light = convertColor(config, Rgb(float(code) / 20), space.name, "lin_rec709");
      EXPECT_NEAR(light.r, light.g, 2e-3F * std::abs(light.g) + 1e-5F) << space.name;
      EXPECT_NEAR(light.b, light.g, 2e-3F * std::abs(light.g) + 1e-5F) << space.name;
      EXPECT_GT(light.g, before) << space.name << " rises";
      before = light.g;
    }
  }
}

TEST(CameraSpaces, PowersAndTheRec709CurveArePublishedOnes) {
  const ColorConfig config("");
  EXPECT_NEAR(linearGrey(config, "gamma22", .5), std::pow(.5, 2.2), 1e-6);
  EXPECT_NEAR(linearGrey(config, "gamma24", .5), std::pow(.5, 2.4), 1e-6);
  // BT.709-6: 4.5 L below .018, 1.099 L^.45 - .099 above.
  for (const double light : {.005, .1, .18, .5, 1.0}) {
    const double code = light < .018 ? 4.5 * light : 1.099 * std::pow(light, .45) - .099;
    EXPECT_NEAR(linearGrey(config, "rec709", code), light, 2e-4) << light;
  }
}

TEST(CameraSpaces, EighteenPerCentGreyIsWhereTheMakersSayItIs) {
  // The code of 18 % grey in each maker's paper.
  const struct {
    const char* space;
    double code;
  } published[] = {{"arri_logc_ei800_awg", .391},         // ARRI LogC curve, usage in VFX, 2017: 400 of 1023
                   {"sony_slog3_sgamut3", 420.0 / 1023},  // Sony S-Log3 technical summary
                   {"sony_slog3_sgamut3cine", 420.0 / 1023},
                   {"panasonic_vlog_vgamut", 433.0 / 1023},  // Panasonic V-Log reference manual: 42 % IRE
                   {"red_log3g10_rwg", 1.0 / 3},             // RED white paper on Log3G10: 1/3
                   {"canon_clog3_cgamut", .343},             // Canon Log 3: 34.3 %
                   {"canon_clog2_cgamut", .398}};            // Canon Log 2: 39.8 %
  const ColorConfig config("");
  for (const auto& maker : published)
    EXPECT_NEAR(linearGrey(config, maker.space, maker.code), .18, .006) << maker.space;
}

TEST(CameraSpaces, PrimariesOfP3AndRec2020ArePublishedOnes) {
  // Rec.709's red in P3 and Rec.2020 (SMPTE EG 432-1, ITU-R BT.2087): what is inside stays inside, white is
  // white.
  const ColorConfig config("");
  for (const char* space : {"lin_p3d65", "lin_rec2020"}) {
    const Rgb white = convertColor(config, Rgb(1), space, "lin_rec709");
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1, 1e-5F);
  }
  const Rgb inP3 = convertColor(config, {1, 0, 0}, "lin_rec709", "lin_p3d65");
  EXPECT_NEAR(inP3.r, .8225F, 2e-4F);
  EXPECT_NEAR(inP3.g, .0332F, 2e-4F);
  EXPECT_NEAR(inP3.b, .0171F, 2e-4F);
  const Rgb in2020 = convertColor(config, {1, 0, 0}, "lin_rec709", "lin_rec2020");
  EXPECT_NEAR(in2020.r, .6274F, 2e-4F);
  EXPECT_NEAR(in2020.g, .0691F, 2e-4F);
  EXPECT_NEAR(in2020.b, .0164F, 2e-4F);
}

}  // namespace
}  // namespace swaplight
