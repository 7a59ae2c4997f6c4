#include "core/relight/level.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

Rig fourLights() {
  const std::array<std::string, 4> names{"key", "fill", "back", "kicker"};
  return defaultRig(names);
}

TEST(Level, IsSaidInPerCentTimesOrStops) {
  for (const char* half :
       {"50%", "50 %", "@50", "@ 50", "@50%", "x0.5", "0.5x", "\u00d70.500", "-1st", "-1.00 st", "-1 stop"})
    EXPECT_EQ(levelFromText(half), 0.5) << half;
  EXPECT_EQ(levelFromText("full"), 1.0);
  EXPECT_EQ(levelFromText("@FULL"), 1.0);
  EXPECT_EQ(levelFromText("out"), 0.0);
  EXPECT_EQ(levelFromText("0%"), 0.0);
  EXPECT_EQ(levelFromText("+1.5 stops"), std::exp2(1.5));
}

TEST(Level, ABareNumberIsMeantInTheUnitThatIsShown) {
  EXPECT_EQ(levelFromText("50", LevelUnit::Percent), 0.5);
  EXPECT_EQ(levelFromText("2", LevelUnit::Multiplier), 2.0);
  EXPECT_EQ(levelFromText("+2", LevelUnit::Stops), 4.0);
  EXPECT_EQ(levelFromText("0", LevelUnit::Stops), 1.0);
  EXPECT_EQ(levelFromText("50%", LevelUnit::Stops), 0.5) << "a unit that is written holds";
  EXPECT_EQ(levelFromText("50"), std::nullopt);
}

TEST(Level, WhatIsNoLevelIsRefused) {
  for (const char* text : {"", "half", "%", "@", "x", "st", "5%%", "nan%", "inf", "3200K", "1/2"})
    EXPECT_EQ(levelFromText(text), std::nullopt) << text;
  for (const char* text : {"-5%", "x-1", "+31st", "-31st", "x1e12", "1e30%"})
    EXPECT_THAT(test::inputError([&] { static_cast<void>(levelFromText(text)); }), testing::HasSubstr(text));
  EXPECT_THAT(test::inputError([] { static_cast<void>(wantedLevel("half", LevelUnit::Stops)); }),
              testing::HasSubstr("50%"));
}

TEST(Level, ALightGetsAllOfItInStops) {
  LightSetting light;
  light.stops = 2;
  light.multiplier = 0.3f;
  setLevel(light, 0.25);
  EXPECT_EQ(light.stops, -2);
  EXPECT_EQ(light.multiplier, 1);
  setLevel(light, 0);
  EXPECT_EQ(levelOf(light), 0);
  setLevel(light, 2);
  EXPECT_EQ(levelOf(light), 2) << "and comes up again";
}

TEST(Level, SeveralLightsAllGoToIt) {
  Rig rig = fourLights();
  rig.lights[0].stops = 3;
  const std::array<size_t, 2> chosen{0, 2};
  rig = withLevel(rig, chosen, 0.5);
  EXPECT_EQ(levelOf(rig.lights[0]), 0.5);
  EXPECT_EQ(levelOf(rig.lights[1]), 1);
  EXPECT_EQ(levelOf(rig.lights[2]), 0.5);
}

TEST(Level, LockedLightsKeepTheirRatio) {
  Rig rig = fourLights();
  for (const size_t i : {0, 1, 3}) rig.lights[i].ratioLock = true;
  rig.lights[1].stops = -2;
  const std::array<size_t, 1> key{0};
  rig = withLevel(rig, key, 0.5);
  EXPECT_EQ(levelOf(rig.lights[0]), 0.5);
  EXPECT_EQ(rig.lights[1].stops, -3);
  EXPECT_EQ(rig.lights[2].stops, 0) << "is not locked";
  EXPECT_EQ(rig.lights[3].stops, -1);
}

}  // namespace
}  // namespace swaplight
