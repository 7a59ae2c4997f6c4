#include "core/relight/light_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/relight/level.h"
#include "core/relight/setting.h"

namespace swaplight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

Rig fiveLights() {
  Rig rig = defaultRig(std::array<std::string, 5>{"key", "fill", "back", "lamp", "kicker"});
  rig.lights[3].label = "desk lamp";
  rig.lights[4].role = Role::Kicker;
  rig.lights[2].group = rig.lights[4].group = "edges";
  rig.groups.push_back({"edges", 0, true});
  return rig;
}

std::vector<size_t> named(const std::string& line) {
  const LightCommand command = lightCommand(fiveLights(), line);
  EXPECT_FALSE(command.changes) << line;
  EXPECT_EQ(command.rig, fiveLights()) << line;
  return command.lights;
}

/// The levels after it, in per cent.
std::vector<int> levels(const std::string& line, std::span<const size_t> chosen = {}) {
  std::vector<int> percent;
  for (const LightSetting& light : lightCommand(fiveLights(), line, chosen).rig.lights)
    percent.push_back(static_cast<int>(std::lround(100 * levelOf(light))));
  return percent;
}

TEST(LightCommand, NamesLightsByNumberNameLabelGroupAndRange) {
  EXPECT_THAT(named("1"), ElementsAre(0));
  EXPECT_THAT(named("KEY"), ElementsAre(0));
  EXPECT_THAT(named("\"Desk lamp\""), ElementsAre(3));
  EXPECT_THAT(named("edges"), ElementsAre(2, 4));
  EXPECT_THAT(named("1 thru 3"), ElementsAre(0, 1, 2));
  EXPECT_THAT(named("4 through fill"), ElementsAre(1, 2, 3));
  EXPECT_THAT(named("1-3"), ElementsAre(0, 1, 2));
  EXPECT_THAT(named("1+4"), ElementsAre(0, 3));
  EXPECT_THAT(named("1, 4,5"), ElementsAre(0, 3, 4));
  EXPECT_THAT(named("key + back"), ElementsAre(0, 2));
  EXPECT_THAT(named("key, back"), ElementsAre(0, 2));
  EXPECT_THAT(named("all - 2 - edges"), ElementsAre(0, 3));
  EXPECT_THAT(named("all except 1 thru 4"), ElementsAre(4));
}

TEST(LightCommand, ARoleNamesLightsWhereNoLightIsCalledSo) {
  Rig rig = defaultRig(std::array<std::string, 2>{"window", "sun"});
  rig.lights[1].role = Role::Key;
  EXPECT_THAT(lightCommand(rig, "key @ 50").lights, ElementsAre(1));
}

TEST(LightCommand, SetsLevelsInPerCentAndInEveryOtherUnit) {
  EXPECT_THAT(levels("1 thru 3 @ 50"), ElementsAre(50, 50, 50, 100, 100));
  EXPECT_THAT(levels("key@25"), ElementsAre(25, 100, 100, 100, 100));
  EXPECT_THAT(levels("edges at -1 st"), ElementsAre(100, 100, 50, 100, 50));
  EXPECT_THAT(levels("fill @ x2"), ElementsAre(100, 200, 100, 100, 100));
  EXPECT_THAT(levels("all @ out"), ElementsAre(0, 0, 0, 0, 0));
  EXPECT_THAT(levels("1 50%"), ElementsAre(50, 100, 100, 100, 100));
}

TEST(LightCommand, WithoutNamesIsAboutTheChosenLights) {
  EXPECT_THAT(levels("@ 50", std::array<size_t, 2>{0, 3}), ElementsAre(50, 100, 100, 50, 100));
  EXPECT_THAT([] { static_cast<void>(levels("@ 50")); },
              ThrowsMessage<InputError>(HasSubstr("name the lights first")));
}

TEST(LightCommand, TakesSeveralSettingsOneAfterTheOther) {
  const Rig rig = lightCommand(fiveLights(), "key + fill gel L201 3200K @ 50 mute").rig;
  for (const size_t i : {0, 1}) {
    EXPECT_EQ(settingText(rig.lights[i]), "3200K,gel:L201,-1st");
    EXPECT_TRUE(rig.lights[i].mute);
  }
  EXPECT_EQ(rig.lights[2], fiveLights().lights[2]);
}

TEST(LightCommand, SaysTheSameAsTheSettingOfTheCommandLine) {
  for (const char* text : {"3200K,+1st", "#4060ff", "rgb:1/0.5/0.2", "gel:L201,x1.7", "off", "@50", "full"}) {
    Rig rig = fiveLights();
    applySetting(rig.lights[1], text);
    EXPECT_EQ(lightCommand(fiveLights(), std::string("fill ") + text).rig, rig) << text;
  }
}

TEST(LightCommand, LockedLightsKeepTheirRatio) {
  Rig rig = fiveLights();
  rig.lights[0].ratioLock = rig.lights[1].ratioLock = true;
  rig.lights[1].stops = -1;
  EXPECT_EQ(lightCommand(rig, "key @ 50").rig.lights[1].stops, -2);
}

TEST(LightCommand, SaysWhatIsWrong) {
  const auto says = [](const char* line, const char* words) {
    EXPECT_THAT([&] { static_cast<void>(lightCommand(fiveLights(), line)); },
                ThrowsMessage<InputError>(HasSubstr(words)))
        << line;
  };
  says("", "1 thru 3 @ 50");
  says("kay @ 50", "'kay' is no light and no setting: lights are 1 key, 2 fill");
  says("7 @ 50", "there is no light 7: lights are 1 key");
  says("99999999999999999999 @ 50", "there is no light");
  says("1 thru", "up to which light");
  says("1 thru gel", "'gel' is no light");
  says("1 +", "name a light");
  says("1 @", "after @ write");
  says("key 50", "write @ 50 for per cent");
  says("key @ loud", "'loud' is no level");
  says("key gel", "after gel");
  says("key gel L99999", "L99999");
  says("key \"desk", "does not end");
  says("key 3200K loud", "'loud' is no light setting");
}

TEST(LightCommandEnds, OffersWhatCanFollow) {
  const Rig rig = fiveLights();
  EXPECT_THAT(lightCommandEnds(rig, "k").words, ElementsAre("key", "kicker"));
  EXPECT_THAT(lightCommandEnds(rig, "key + f").words, ElementsAre("fill", "full"));
  EXPECT_THAT(lightCommandEnds(rig, "\"").words, ElementsAre("\"desk lamp\""));
  EXPECT_THAT(lightCommandEnds(rig, "key gel l20").words, testing::Contains("L201"));
  EXPECT_THAT(lightCommandEnds(rig, "1 t").words, ElementsAre("thru"));
  EXPECT_THAT(lightCommandEnds(rig, "1 thru 3 @ f").words, ElementsAre("full"));
  EXPECT_THAT(lightCommandEnds(rig, "key 3200K mu").words, ElementsAre("mute"));
  EXPECT_EQ(lightCommandEnds(rig, "1 thru k").from, 7U);
  EXPECT_TRUE(lightCommandEnds(rig, "zzz").words.empty());
}

// Whatever is typed on the way to a line.
TEST(LightCommandEnds, CanBeAskedAtAnyTime) {
  const std::string line = "all - \"desk lamp\" + 1 thru 3 @ 50, gel L201 rgb:1/0.5/0.2 mute";
  for (size_t length = 0; length <= line.size(); ++length)
    EXPECT_NO_THROW(static_cast<void>(lightCommandEnds(fiveLights(), line.substr(0, length)))) << length;
}

}  // namespace
}  // namespace swaplight
