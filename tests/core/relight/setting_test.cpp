#include "core/relight/setting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/color/chromaticity.h"
#include "core/color/srgb.h"
#include "core/lamp/kelvin.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

LightSetting parsed(const std::string& text) {
  LightSetting setting;
  applySetting(setting, text);
  return setting;
}

Rgb factor(const std::string& text) {
  return lightFactor(parsed(text));
}

std::string errorOf(const std::string& text) {
  LightSetting setting;
  const std::string error = test::inputError([&] { applySetting(setting, text); });
  EXPECT_EQ(setting, LightSetting()) << "a setting that is wrong changes nothing: " << text;
  return error;
}

TEST(Setting, EveryFormOfTheGrammarHasItsFactor) {
  EXPECT_EQ(factor("on"), Rgb(1));
  EXPECT_EQ(factor("white"), Rgb(1));
  EXPECT_EQ(factor("off"), Rgb(0));
  EXPECT_EQ(factor("#ffffff"), Rgb(1));
  EXPECT_EQ(factor("#FF0000"), Rgb(1, 0, 0));
  EXPECT_NEAR(factor("#4060ff").x, linearFromSrgb(64 / 255.0f), 1e-6);
  EXPECT_EQ(factor("rgb:0.9/0.5/12"), Rgb(0.9f, 0.5f, 12));
  EXPECT_NEAR(factor("hsv:0/1/1").x, 1, 1e-6);
  EXPECT_NEAR(factor("hsv:120/1/1").y, 1, 1e-6);
  EXPECT_NEAR(factor("hsv:0.6666667/1/1").z, 1, 1e-5);
  EXPECT_NEAR(factor("hsv:0/0/0.5").y, linearFromSrgb(0.5f), 1e-6);
  EXPECT_EQ(factor("+1.5st"), Rgb(std::exp2(1.5f)));
  EXPECT_EQ(factor("-2st"), Rgb(0.25f));
  EXPECT_EQ(factor("1st"), Rgb(2));
  EXPECT_EQ(factor("x1.7"), Rgb(1.7f));
  EXPECT_EQ(factor("x2,+1st"), Rgb(4));
  EXPECT_EQ(factor("x2,+1st,50%"), Rgb(0.5f)) << "all of the level";
  EXPECT_EQ(factor("@25"), Rgb(0.25f));
  EXPECT_EQ(factor("-3st,full"), Rgb(1));
  EXPECT_EQ(factor("out"), Rgb(0));
  EXPECT_EQ(factor("out,50%"), Rgb(0.5f));
  EXPECT_EQ(factor("off,+1st"), Rgb(0));
  EXPECT_EQ(factor(" 3200K , +1st "), 2.0f * factor("3200k"));
}

TEST(Setting, KelvinHasLuminanceOneAndItsChromaticity) {
  const Rgb rgb = factor("3200K");
  EXPECT_NEAR(luminance(rgb), 1, 1e-6);
  EXPECT_NEAR(xyFromRec709(rgb).x, 0.4234, 1e-3);
  EXPECT_NEAR(xyFromRec709(rgb).y, 0.3990, 1e-3);
}

TEST(Setting, GreenMovesAcrossTheLocusAndKeepsLuminance) {
  const Rgb rgb = factor("4000K,green:+1");
  EXPECT_NEAR(luminance(rgb), 1, 1e-6);
  EXPECT_NEAR(correlatedTemperature(xyFromRec709(rgb)).duv, kFullGreenDuv, 1e-4);
  EXPECT_NEAR(correlatedTemperature(xyFromRec709(factor("4000K,green:-0.5"))).duv, -kFullGreenDuv / 2, 1e-4);
  EXPECT_GT(factor("#808080,green:1").y, factor("#808080").y);
}

TEST(Setting, AGelLiesOverTheLampInWhateverOrderTheyAreNamed) {
  EXPECT_EQ(factor("3200K,gel:L201"), factor("gel:l201,3200K"));
  EXPECT_EQ(factor("3200K,gel:L201"), factor("l201,3200K"));
  const double kelvin = correlatedTemperature(xyFromRec709(factor("3200K,gel:L201"))).kelvin;
  EXPECT_NEAR(kelvin, 5700, 60);
  EXPECT_NEAR(correlatedTemperature(xyFromRec709(factor("gel:L204"))).kelvin, 3200, 20);
  EXPECT_EQ(factor("gel:L201,gel:none"), Rgb(1));
  const Rgb red = factor("#ff8080,gel:L209");
  EXPECT_NEAR(red.x, 0.501f, 1e-3);
}

TEST(Setting, ALaterPartOverridesAnEarlierOneAndLeavesTheOthers) {
  LightSetting setting = parsed("3200K,+1st,gel:L202");
  applySetting(setting, "5600K");
  EXPECT_EQ(setting, parsed("5600K,gel:L202,+1st"));
  applySetting(setting, "off");
  EXPECT_FALSE(setting.on);
  EXPECT_EQ(setting.color.kelvin, 5600);
}

TEST(Setting, AnErrorQuotesThePartAndSaysWhatWouldBeRight) {
  EXPECT_THAT(errorOf("3200K,fish"),
              testing::AllOf(testing::HasSubstr("'fish'"), testing::HasSubstr("3200K")));
  EXPECT_THAT(errorOf(""), testing::HasSubstr("''"));
  EXPECT_THAT(errorOf("on,"), testing::HasSubstr("''"));
  EXPECT_THAT(errorOf("#12345"),
              testing::AllOf(testing::HasSubstr("'#12345'"), testing::HasSubstr("#4060ff")));
  EXPECT_THAT(errorOf("#12345g"), testing::HasSubstr("six hexadecimal"));
  EXPECT_THAT(errorOf("#-1+2ff"), testing::HasSubstr("six hexadecimal"));
  EXPECT_THAT(errorOf("rgb:1/2"), testing::HasSubstr("rgb:0.9/0.5/0.2"));
  EXPECT_THAT(errorOf("rgb:1/2/3/4"), testing::HasSubstr("rgb:0.9/0.5/0.2"));
  EXPECT_THAT(errorOf("rgb:1/-2/3"), testing::HasSubstr("rgb:0.9/0.5/0.2"));
  EXPECT_THAT(errorOf("rgb:1/nan/inf"), testing::HasSubstr("rgb:0.9/0.5/0.2"));
  EXPECT_THAT(errorOf("hsv:400/1/1"), testing::HasSubstr("hsv:210/0.8/1"));
  EXPECT_THAT(errorOf("500K"), testing::HasSubstr("1000K to 25000K"));
  EXPECT_THAT(errorOf("1e9K"), testing::HasSubstr("1000K to 25000K"));
  EXPECT_THAT(errorOf("green:2"), testing::HasSubstr("-1 to +1"));
  EXPECT_THAT(errorOf("gel:L9999"), testing::AllOf(testing::HasSubstr("L9999"), testing::HasSubstr("L204")));
  EXPECT_THAT(errorOf("+99st"), testing::HasSubstr("-30st to +30st"));
  EXPECT_THAT(errorOf("x-1"), testing::HasSubstr("from 0 to 1e9"));
  EXPECT_THAT(errorOf("xinf"), testing::HasSubstr("no light setting"));
  EXPECT_THAT(errorOf("1.5"), testing::HasSubstr("'1.5'"));
}

TEST(Setting, TextIsTheShortestThatComesBack) {
  EXPECT_EQ(settingText(parsed("on")), "on");
  EXPECT_EQ(settingText(parsed("off")), "off");
  EXPECT_EQ(settingText(parsed("x1.7,+1.5st,green:+0.25,gel:l201,3200k")),
            "3200K,gel:L201,green:+0.25,+1.5st,x1.7");
  EXPECT_EQ(settingText(parsed("#4060FF,-2st,off")), "off,#4060ff,-2st");
  EXPECT_EQ(settingText(parsed("rgb:0.1/0.2/3")), "rgb:0.1/0.2/3");
}

TEST(Setting, RandomSettingsComeBackFromTheirText) {
  std::mt19937 random(7);
  const auto unit = [&] { return std::uniform_real_distribution<float>(0, 1)(random); };
  using Kind = LightColor::Kind;
  for (int i = 0; i < 2000; ++i) {
    LightSetting setting;
    setting.color.kind = static_cast<Kind>(random() % 5);
    if (setting.color.kind == Kind::Kelvin)
      setting.color.kelvin = 1000 + 24000 * unit();
    else if (setting.color.kind == Kind::Hex)
      setting.color.value = {(random() % 256) / 255.0f, (random() % 256) / 255.0f, (random() % 256) / 255.0f};
    else if (setting.color.kind != Kind::White)
      setting.color.value = {unit(), unit(), unit()};
    if (random() % 3 == 0) setting.color.gel = "L202";
    if (random() % 3 == 0) setting.color.green = 2 * unit() - 1;
    if (random() % 2) setting.stops = 20 * unit() - 10;
    if (random() % 2) setting.multiplier = 3 * unit();
    setting.on = random() % 4 != 0;
    EXPECT_EQ(parsed(settingText(setting)), setting) << settingText(setting);
  }
}

TEST(Setting, AColorBetweenTheCodesOfHexKeepsItsValue) {
  LightSetting setting;
  setting.color.kind = LightColor::Kind::Hex;
  setting.color.value = {0.3003f, 0.5, 0.7};
  const Rgb again = lightFactor(parsed(settingText(setting)));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(again[c], lightFactor(setting)[c], 1e-6);
}

}  // namespace
}  // namespace swaplight
