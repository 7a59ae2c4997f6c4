#include "core/relight/rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/relight/setting.h"

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
          testing::AllOf(testing::HasSubstr("'fill'"), testing::HasSubstr("key, back"))));
}

TEST(Rig, WrongJsonIsSaidWithItsPlace) {
  const auto message = [](const char* text) {
    try {
      static_cast<void>(rigFromJson(Json::parse(text), "my.json"));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing thrown");
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
