#include "core/relight/rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/relight/setting.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

Capture captureOf(std::initializer_list<const char*> names) {
  Capture capture;
  for (const char* name : names) capture.lights.push_back({name, Role::Key, Json::object()});
  return capture;
}

TEST(Rig, TheDefaultIsEveryLightAtUnitWhite) {
  const Rig rig = defaultRig(captureOf({"key", "fill"}));
  EXPECT_EQ(rigFactors(rig), std::vector<Rgb>(2, Rgb(1)));
  EXPECT_EQ(rig.lights[1].light, "fill");
  EXPECT_EQ(rig.lights[1].role, Role::Key);
}

TEST(Rig, SoloTurnsTheOthersOffAndMuteWins) {
  Rig rig = defaultRig(captureOf({"a", "b", "c"}));
  rig.lights[1].solo = true;
  EXPECT_EQ(rigFactors(rig), (std::vector<Rgb>{Rgb(0), Rgb(1), Rgb(0)}));
  rig.lights[1].mute = true;
  EXPECT_EQ(rigFactors(rig), std::vector<Rgb>(3, Rgb(0)));
  rig.lights[1].solo = false;
  EXPECT_EQ(rigFactors(rig), (std::vector<Rgb>{Rgb(1), Rgb(0), Rgb(1)}));
}

TEST(Rig, FactorsForOtherPrimariesKeepWhiteAndLuminance) {
  Rig rig = defaultRig(captureOf({"white", "red", "off"}));
  applySetting(rig.lights[1], "rgb:1/0/0");
  applySetting(rig.lights[2], "off");
  const std::vector<Rgb> factors = rigFactors(test::builtinColors(), rig, "acescg");
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(factors[0][c], 1, 1e-4);
    EXPECT_EQ(factors[2][c], 0);
  }
  // Rec.709 red in ACEScg (Bradford): 0.6131, 0.0702, 0.0206.
  EXPECT_NEAR(factors[1].x, 0.6131f, 2e-3);
  EXPECT_NEAR(factors[1].y, 0.0702f, 2e-3);
  EXPECT_NEAR(factors[1].z, 0.0206f, 2e-3);
  EXPECT_EQ(rigFactors(test::builtinColors(), rig, "lin_rec709"), rigFactors(rig));
}

TEST(Rig, ComesBackFromJson) {
  Rig rig = defaultRig(captureOf({"key", "fill"}));
  rig.ambient = 0.25f;
  applySetting(rig.lights[0], "3200K,gel:L202,green:-0.25,+1.5st");
  rig.lights[1].solo = rig.lights[1].ratioLock = true;
  applySetting(rig.lights[1], "#4060ff,x0.3,off");
  EXPECT_EQ(rigFromJson(jsonFromRig(rig)), rig);
  EXPECT_EQ(jsonFromRig(rig)["lights"][0]["color"], "3200K,gel:L202,green:-0.25");
}

TEST(Rig, ForAnotherSetTakesTheLightsByName) {
  Rig rig = defaultRig(captureOf({"fill", "key"}));
  rig.lights[1].stops = 2;
  const Rig fitted = rigFor(captureOf({"key", "back", "fill"}), rig);
  ASSERT_EQ(fitted.lights.size(), 3u);
  EXPECT_EQ(fitted.lights[0].light, "key");
  EXPECT_EQ(fitted.lights[0].stops, 2);
  EXPECT_EQ(fitted.lights[1].stops, 0);
  EXPECT_THAT(
      [&] {
        static_cast<void>(rigFor(captureOf({"key", "back"}), rig));
      },
      testing::ThrowsMessage<InputError>(
          testing::AllOf(testing::HasSubstr("\"fill\""), testing::HasSubstr("key, back"))));
}

TEST(Rig, WrongJsonIsSaidWithItsPlace) {
  const auto message = [](const char* text) {
    return test::inputError([&] { static_cast<void>(rigFromJson(Json::parse(text), "my.json")); });
  };
  EXPECT_THAT(message("[]"), testing::StartsWith("my.json: "));
  EXPECT_THAT(message("{}"), testing::HasSubstr("lights"));
  EXPECT_THAT(message(R"({"lights": [{}]})"), testing::HasSubstr("light 1: \"name\" is missing"));
  EXPECT_THAT(message(R"({"lights": [{"name": "key", "color": "fish"}]})"),
              testing::AllOf(testing::HasSubstr("(key)"), testing::HasSubstr("'fish'")));
  EXPECT_THAT(message(R"({"lights": [{"name": "key", "on": 1}]})"), testing::HasSubstr("true or false"));
  EXPECT_THAT(message(R"({"lights": [{"name": "key", "stops": "two"}]})"), testing::HasSubstr("stops"));
  EXPECT_THAT(message(R"({"format": "swaplight-capture", "lights": []})"),
              testing::HasSubstr("swaplight-rig"));
  EXPECT_THAT(message(R"({"version": 9, "lights": []})"), testing::HasSubstr("version 9"));
}

}  // namespace
}  // namespace swaplight
