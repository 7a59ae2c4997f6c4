#include "core/cue/cue_list.h"

#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/cue/cue_command.h"

namespace swaplight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<int> numbers(const CueList& cues) {
  std::vector<int> all;
  for (const Cue& cue : cues) all.push_back(cue.number);
  return all;
}

CueList threeCues() {
  return {{100, "Day"}, {200, "Dusk", 4}, {300, "Night", 6, 2}};
}

const std::vector<SavedLook> kGallery = {{"Day", "", {}}, {"Dusk", "", {}}, {"Late Night", "", {}}};

/// What the refusal says.
template <typename Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "(nothing)";
}

CueList after(const char* line) {
  return cueCommand(threeCues(), kGallery, line).cues;
}

std::string refused(const char* line) {
  return refusal([&] { static_cast<void>(cueCommand(threeCues(), kGallery, line)); });
}

TEST(CueList, StandsInTheOrderOfItsNumbers) {
  const CueList cues = withCue(threeCues(), {250, "Between"});
  EXPECT_THAT(numbers(cues), ElementsAre(100, 200, 250, 300));
  EXPECT_EQ(cueAfter(cues, 200)->number, 250);
  EXPECT_EQ(cueAfter(cues, 225)->number, 250) << "of a cue that is no more";
  EXPECT_EQ(cueAfter(cues, 300), nullptr);
  EXPECT_EQ(cueAfter(cues, {})->number, 100);
  EXPECT_EQ(cueBefore(cues, 250)->number, 200);
  EXPECT_EQ(cueBefore(cues, 100), nullptr);
  EXPECT_EQ(cueBefore(cues, {}), nullptr);
  EXPECT_EQ(freeCueNumber({}), 100);
  EXPECT_EQ(freeCueNumber({{250, "Day"}}), 300);
  EXPECT_EQ(freeCueNumber({{kMostCueNumber - 1, "Day"}, {kMostCueNumber, "Night"}}), kMostCueNumber - 2)
      << "the last number there is must not be replaced";
  EXPECT_EQ(withCue(cues, {250, "Other"})[2].look, "Other");
}

TEST(CueList, FollowsTheGallerysNames) {
  EXPECT_EQ(withLookRenamed(threeCues(), "dusk", "Evening")[1].look, "Evening");
  EXPECT_THAT(numbers(withoutLook(threeCues(), "Dusk")), ElementsAre(100, 300));
  EXPECT_THAT(refusal([] { static_cast<void>(lookOf(threeCues()[2], kGallery)); }),
              HasSubstr("cue 3: the gallery has no look \"Night\""));
}

TEST(CueList, NumbersAreHundredths) {
  EXPECT_EQ(cueNumberFromText("2.5"), 250);
  EXPECT_EQ(cueNumberFromText("9999"), kMostCueNumber);
  EXPECT_EQ(cueNumberFromText("0.01"), 1);
  for (const char* text : {"0", "-1", "2.505", "10000", "two", "", "1e9"})
    EXPECT_EQ(cueNumberFromText(text), std::nullopt) << text;
  EXPECT_EQ(cueNumberText(250), "2.5");
  EXPECT_EQ(cueNumberText(1200), "12");
  for (int number = 1; number <= kMostCueNumber; number += 37)
    ASSERT_EQ(cueNumberFromText(cueNumberText(number)), number);
}

TEST(CueList, ReadsWhatItWrites) {
  const CueList cues = withCue(threeCues(), {1234, "Day", 2.3F, 0.F});
  EXPECT_EQ(cuesFromJson(jsonFromCues(cues), "cue"), cues);
  EXPECT_EQ(jsonFromCues(cues)[3]["fade"].dump(), "2.3");
  EXPECT_EQ(jsonFromCues(cues)[3]["id"], 12.34);
  EXPECT_FALSE(jsonFromCues(cues)[0].contains("follow"));
}

TEST(CueList, SaysWhatIsWrongInAFile) {
  const auto said = [](const char* text) {
    return refusal([&] { static_cast<void>(cuesFromJson(Json::parse(text), "s: cue")); });
  };
  EXPECT_THAT(said("{}"), HasSubstr("s: cues: must be a list"));
  EXPECT_THAT(said(R"([{"id": 0, "look": "a"}])"), HasSubstr("s: cue 1: give"));
  EXPECT_THAT(said(R"([{"id": 1}])"), HasSubstr("s: cue 1: give"));
  EXPECT_THAT(said(R"([{"id": 1, "look": "a"}, {"id": 1, "look": "b"}])"), HasSubstr("two with the id 1"));
  EXPECT_THAT(said(R"([{"id": 1, "look": "a", "fade": -1}])"), HasSubstr("fade"));
}

TEST(CueCommand, SetsTimesOfOneCueOrMany) {
  EXPECT_EQ(after("3 time 4")[2], (Cue{300, "Night", 4, 2}));
  EXPECT_EQ(after("1 thru 2 time 1.5s follow 0")[1], (Cue{200, "Dusk", 1.5F, 0.F}));
  EXPECT_EQ(after("3 follow off")[2].followSeconds, std::nullopt);
  EXPECT_EQ(after("3 FADE 0")[2].fadeSeconds, 0);
}

TEST(CueCommand, GivesACueALookAndAddsItWhereItIsNew) {
  EXPECT_EQ(after("2 look 3")[1], (Cue{200, "Late Night", 4}));
  EXPECT_EQ(after("2 look late night time 9")[1], (Cue{200, "Late Night", 9}));
  EXPECT_EQ(after("2 look 3 time 9")[1], (Cue{200, "Late Night", 9}));
  EXPECT_EQ(after("2.5 look Day time 1")[2], (Cue{250, "Day", 1}));
  EXPECT_THAT(refused("2 look Dawn"), HasSubstr("'Dawn' is no look of the gallery, which has 3"));
}

TEST(CueCommand, MovesAndRemoves) {
  EXPECT_THAT(numbers(after("3 number 0.5")), ElementsAre(50, 100, 200));
  EXPECT_THAT(numbers(after("2 thru 3 remove")), ElementsAre(100));
  EXPECT_THAT(refused("3 number 2"), HasSubstr("there is a cue 2 already"));
  EXPECT_EQ(after("3 number 3"), threeCues());
}

TEST(CueCommand, SaysWhatIsWrong) {
  EXPECT_THAT(refused("7 time 4"), HasSubstr("there is no cue 7: cues are 1, 2, 3"));
  EXPECT_THAT(refused("3"), HasSubstr("say what becomes of cue 3"));
  EXPECT_THAT(refused("3 time"), HasSubstr("after time write what"));
  EXPECT_THAT(refused("3 time soon"), HasSubstr("'soon' is no time"));
  EXPECT_THAT(refused("3 time -1"), HasSubstr("no time"));
  EXPECT_THAT(refused("3 louder"), HasSubstr("'louder' is nothing that a cue has"));
  EXPECT_THAT(refused("night time 2"), HasSubstr("'night' is no number of a cue"));
  EXPECT_THAT(refused(""), HasSubstr("after cue write what"));
  EXPECT_THAT(refused("7 thru 9 time 4"), HasSubstr("no cue from 7 to 9"));
}

TEST(GoRequest, NextBackAndByNumber) {
  const CueList cues = threeCues();
  const auto number = [&](const char* text, std::optional<int> now, std::optional<int> loaded = {}) {
    return cueOfRequest(cues, goRequestFromText(text), now, loaded).number;
  };
  EXPECT_EQ(number("", {}), 100);
  EXPECT_EQ(number("next", 100), 200);
  EXPECT_EQ(number("next", 100, 300), 300) << "the one that was loaded";
  EXPECT_EQ(number("back", 300), 200);
  EXPECT_EQ(number("2", 300), 200);
  EXPECT_EQ(number("dusk in 4", {}), 200);
  EXPECT_EQ(goRequestFromText("3 in 2.5s").seconds, 2.5F);
  EXPECT_EQ(goRequestFromText("in 4").seconds, 4.F);
  EXPECT_EQ(goRequestFromText("3").seconds, std::nullopt);
}

TEST(GoRequest, SaysWhereThereIsNone) {
  const CueList cues = threeCues();
  const auto said = [&](const char* text, std::optional<int> now) {
    return refusal([&] { static_cast<void>(cueOfRequest(cues, goRequestFromText(text), now)); });
  };
  EXPECT_THAT(said("", 300), HasSubstr("cue 3 is the last one"));
  EXPECT_THAT(said("back", 100), HasSubstr("there is no cue before"));
  EXPECT_THAT(said("back", {}), HasSubstr("there is no cue before"));
  EXPECT_THAT(said("7", {}), HasSubstr("there is no cue 7: cues are 1, 2, 3"));
  EXPECT_THAT(said("3 in never", {}), HasSubstr("'never' is no fade time"));
  EXPECT_THAT(refusal([] { static_cast<void>(cueOfRequest({}, {}, {})); }),
              HasSubstr("the cue list is empty"));
}

}  // namespace
}  // namespace swaplight
