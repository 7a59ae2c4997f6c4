#include <gtest/gtest.h>

#include "core/base/json.h"
#include "core/ocio/color_config.h"
#include "core/relight/relight.h"
#include "core/relight/rig_edit.h"
#include "core/relight/setting.h"
#include "core/set/set_color_space.h"
#include "tests/support/builtin_colors.h"

namespace swaplight {
namespace {

SolvedSet twoLights() {
  SolvedSet set;
  for (const char* name : {"key", "fill"}) {
    set.capture.lights.push_back({name, Role::Other, Json::object()});
    set.contributions.emplace_back(ImageSpec::rgb(2, 1), 0.0F);
  }
  const auto put = [&](size_t light, int x, Rgb value) {
    for (int c = 0; c < 3; ++c) set.contributions[light].plane(c)[x] = value[c];
  };
  put(0, 0, {0.5F, 0.3F, 0.2F});
  put(1, 0, {0.1F, 0.2F, 0.1F});
  put(1, 1, {0.3F, 0.3F, 0.4F});
  updateBeta(set);
  set.capture.shots.push_back({"a.exr", {Rgb(0.9F, 0.2F, 0.1F), Rgb(0.1F, 0.8F, 0.3F)}, {}, 0, false, {}});
  set.capture.shots.push_back({"b.exr", {Rgb(0.1F, 0.8F, 0.3F), std::nullopt}, {}, 1.5F, false, {}});
  return set;
}

TEST(RigEdit, AsCapturedGivesThePhotographAgain) {
  const SolvedSet set = twoLights();
  const Rig rig = rigOfShot(test::builtinColors(), defaultRig(set.capture), set, 0);
  const Image frame = relight(set, rigFactors(rig));
  EXPECT_FLOAT_EQ(frame.plane(0)[0], 0.9F * 0.5F + 0.1F * 0.1F);
  EXPECT_FLOAT_EQ(frame.plane(1)[0], 0.2F * 0.3F + 0.8F * 0.2F);
  const Rig second = rigOfShot(test::builtinColors(), defaultRig(set.capture), set, 1);
  EXPECT_EQ(second.lights[0].stops, 1.5F);
  EXPECT_EQ(second.lights[1], defaultRig(set.capture).lights[1]);  // unknown there
}

TEST(RigEdit, AsCapturedIsTheSameInEveryWorkingSpace) {
  const SolvedSet own = twoLights();
  const SolvedSet wide = copyInColorSpace(test::builtinColors(), own, "acescg");
  EXPECT_EQ(wide.colorSpace(), "acescg");
  EXPECT_EQ(own.colorSpace(), "lin_rec709") << "the set itself stays";
  EXPECT_EQ(rigOfShot(test::builtinColors(), defaultRig(wide.capture), wide, 0),
            rigOfShot(test::builtinColors(), defaultRig(own.capture), own, 0));
  Image frame = sumAtUnitWhite(wide);
  test::builtinColors().convert(frame.span(), "acescg", "lin_rec709");
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(frame.plane(c)[0], sumAtUnitWhite(own).plane(c)[0], 1e-6F);
}

TEST(RigEdit, AChosenLightMakesAPixelNeutralAndTheOthersStay) {
  const SolvedSet set = twoLights();
  Rig rig = defaultRig(set.capture);
  applySetting(rig.lights[0], "3200K,+0.5st");
  const size_t chosen[] = {0};
  const PixelShares shares = pixelShares(set, 0, 0);
  const std::optional<Rig> neutral =
      neutralizePixel(test::builtinColors(), rig, shares, chosen, "lin_rec709");
  ASSERT_TRUE(neutral);
  EXPECT_EQ(neutral->lights[1], rig.lights[1]);
  EXPECT_EQ(neutral->lights[0].stops, 0.5F);
  const Image before = relight(set, rigFactors(rig));
  const Image after = relight(set, rigFactors(*neutral));
  EXPECT_NEAR(after.plane(0)[0], after.plane(1)[0], 1e-5);
  EXPECT_NEAR(after.plane(0)[0], after.plane(2)[0], 1e-5);
  const auto sum = [](const Image& image) {
    return image.plane(0)[0] + image.plane(1)[0] + image.plane(2)[0];
  };
  EXPECT_NEAR(sum(after), sum(before), 1e-5);
}

TEST(RigEdit, ALightThatDoesNotReachAPixelCannotMakeItNeutral) {
  const SolvedSet set = twoLights();
  const size_t chosen[] = {0};
  EXPECT_FALSE(neutralizePixel(test::builtinColors(), defaultRig(set.capture), pixelShares(set, 1, 0), chosen,
                               "lin_rec709"));
}

TEST(RigEdit, LockedLightsKeepTheirRatio) {
  Rig rig = defaultRig(std::vector<std::string>{"key", "fill", "back"});
  rig.lights[0].ratioLock = rig.lights[1].ratioLock = true;
  rig.lights[1].stops = -2;
  const size_t key[] = {0};
  const size_t back[] = {2};
  rig = addStops(rig, key, 1.5F);
  EXPECT_EQ(rig.lights[0].stops, 1.5F);
  EXPECT_EQ(rig.lights[1].stops, -0.5F);
  EXPECT_EQ(rig.lights[2].stops, 0);
  rig = addStops(rig, back, 1);
  EXPECT_EQ(rig.lights[0].stops, 1.5F);
  EXPECT_EQ(addStops(rig, key, -30).lights[1].stops, -kMostStops) << "or the session could not be read again";
  EXPECT_EQ(withLevel(rig, key, std::exp2(-30)).lights[1].stops, -kMostStops);
}

TEST(RigEdit, AGroupIsAFaderOverItsLights) {
  Rig rig = defaultRig(std::vector<std::string>{"key", "fill"});
  rig.groups.push_back({"window", 1, true});
  rig.lights[0].group = "window";
  EXPECT_EQ(rigFactors(rig)[0], Rgb(2));
  EXPECT_EQ(rigFactors(rig)[1], Rgb(1));
  rig.groups[0].on = false;
  EXPECT_EQ(rigFactors(rig)[0], Rgb(0));
  EXPECT_EQ(rigFromJson(jsonFromRig(rig)), rig);
  rig.lights[0].group = "gone";
  EXPECT_EQ(rigFactors(rig)[0], Rgb(1));
}

TEST(RigEdit, AResetLightKeepsItsNameAndPlace) {
  LightSetting light;
  light.light = "key";
  light.label = "Window";
  light.group = "day";
  applySetting(light, "3200K,+1st,off");
  const LightSetting reset = resetLight(light);
  EXPECT_EQ(reset.label, "Window");
  EXPECT_EQ(reset.group, "day");
  EXPECT_TRUE(reset.on);
  EXPECT_EQ(lightFactor(reset), Rgb(1));
  LightSetting other;
  other.light = "fill";
  const LightSetting pasted = pastedLight(other, light);
  EXPECT_EQ(pasted.light, "fill");
  EXPECT_EQ(pasted.color, light.color);
  EXPECT_FALSE(pasted.on);
}

TEST(RigEdit, SharesOfAPixelAddUpToTheRelitPicture) {
  SolvedSet set = twoLights();
  set.ambient.emplace(ImageSpec::rgb(2, 1), 0.05F);
  Rig rig = defaultRig(set.capture);
  applySetting(rig.lights[0], "3200K,+1st");
  rig.ambient = 2;
  const Image relit = relight(set, rigFactors(rig), rig.ambient);
  const std::vector<Rgb> shares =
      relitShares(test::builtinColors(), rig, pixelShares(set, 0, 0), "lin_rec709");
  ASSERT_EQ(shares.size(), 3U);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(shares[0][c] + shares[1][c] + shares[2][c], relit.plane(c)[0], 1e-5F);
}

TEST(RigEdit, ALightTakesTheHueOfAPixelWhateverItsBrightness) {
  const LightColor color = lightColorOfPixel(test::builtinColors(), {0.5F, 0.25F, 0.1F}, "lin_rec709");
  const Rgb factor = colorFactor(color);
  EXPECT_NEAR(factor.r, 1, 1e-4F);
  EXPECT_NEAR(factor.g, 0.5F, 1e-4F);
  EXPECT_NEAR(factor.b, 0.2F, 1e-4F);
  EXPECT_EQ(lightColorOfPixel(test::builtinColors(), Rgb(0), "lin_rec709"), LightColor{});
}

}  // namespace
}  // namespace swaplight
