#include "core/relight/live_level.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace swaplight {
namespace {

Rig threeLights() {
  return defaultRig(std::array<std::string, 3>{"key", "fill", "back"});
}

TEST(LiveLevel, IsTheLightsOwnTimesItsGroups) {
  Rig rig = threeLights();
  rig.lights[0].stops = 1;
  rig.lights[0].multiplier = 0.25F;
  rig.lights[0].group = "windows";
  EXPECT_DOUBLE_EQ(liveLevel(rig, 0).level, 0.5) << "a group that is not there changes nothing";
  rig.groups.push_back({"windows", -2, true});
  EXPECT_DOUBLE_EQ(liveLevel(rig, 0).level, 0.125);
  EXPECT_DOUBLE_EQ(liveLevel(rig, 1).level, 1);
}

TEST(LiveLevel, SaysWhatHoldsALightBack) {
  Rig rig = threeLights();
  rig.groups.push_back({"windows", 0, false});
  rig.lights[1].group = "windows";
  EXPECT_EQ(liveLevel(rig, 1).by, HeldBack::GroupOff);
  rig.lights[0].solo = true;
  EXPECT_EQ(liveLevel(rig, 2).by, HeldBack::NotInSolo);
  EXPECT_EQ(liveLevel(rig, 0).by, HeldBack::Nothing);
  rig.lights[2].on = false;
  EXPECT_EQ(liveLevel(rig, 2).by, HeldBack::Off);
  rig.lights[2].mute = true;
  EXPECT_EQ(liveLevel(rig, 2).by, HeldBack::Muted);
  rig.lights[0].multiplier = 0;
  EXPECT_EQ(liveLevel(rig, 0).by, HeldBack::LevelZero);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(liveLevel(rig, i).level, 0) << i;
}

// What the row of a light says is what the picture does.
TEST(LiveLevel, IsZeroWhereTheFactorIs) {
  for (int switches = 0; switches < 64; ++switches) {
    Rig rig = threeLights();
    rig.groups.push_back({"windows", -1, (switches & 1) == 0});
    rig.lights[0].group = "windows";
    rig.lights[0].on = (switches & 2) == 0;
    rig.lights[0].mute = (switches & 4) != 0;
    rig.lights[0].solo = (switches & 8) != 0;
    rig.lights[1].solo = (switches & 16) != 0;
    rig.lights[0].multiplier = (switches & 32) != 0 ? 0.F : 2.F;
    const Rgb factor = rigFactors(rig)[0];
    EXPECT_FLOAT_EQ(static_cast<float>(liveLevel(rig, 0).level), factor.g) << switches;
  }
}

}  // namespace
}  // namespace swaplight
