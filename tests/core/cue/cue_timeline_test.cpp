#include "core/cue/cue_timeline.h"

#include <gmock/gmock.h>

#include <glm/common.hpp>

#include "core/base/error.h"

namespace swaplight {
namespace {

using testing::HasSubstr;

LightSetting light(const char* name, float stops, const LightColor& color = {}) {
  LightSetting setting;
  setting.light = name;
  setting.stops = stops;
  setting.color = color;
  return setting;
}

LightColor kelvin(float value) {
  LightColor color;
  color.kind = LightColor::Kind::Kelvin;
  color.kelvin = value;
  return color;
}

Edit gain(float stops, float opacity = 1) {
  Edit edit;
  edit.name = "Brighter";
  edit.opacity = opacity;
  edit.operation = GainOperation{stops, .5F};
  return edit;
}

const Rig kDay{{light("key", 0, kelvin(5600)), light("fill", -1)}, {}, 1};
const Rig kNight{{light("key", -4, kelvin(3200)), light("fill", -2)}, {}, .25F};

CueTimeline dayToNight(const CueTiming& timing = {}) {
  const std::vector<SavedLook> looks = {{"Day", "", kDay}, {"Night", "", kNight}};
  return {{{100, "Day", 9}, {200, "Night", 2, 5}}, looks, {kDay, {}}, timing};
}

TEST(CueTimeline, AddsUpHoldsAndFadesInFrames) {
  const CueTimeline show = dayToNight({24, 1, 1});
  EXPECT_EQ(show.firstFrame(), 1);
  EXPECT_EQ(show.places()[0].ends, 25) << "held for a second: its own fade has nothing to come from";
  EXPECT_EQ(show.places()[1].begins, 25);
  EXPECT_EQ(show.places()[1].stands, 73) << "two seconds later";
  EXPECT_EQ(show.lastFrame(), 97) << "nothing follows the last cue: it is held";
  EXPECT_EQ(show.at(1).rig, kDay);
  EXPECT_EQ(show.at(25).rig, kDay);
  EXPECT_EQ(show.at(73).rig, kNight);
  EXPECT_EQ(show.at(1000).rig, kNight);
}

TEST(CueTimeline, FadesEvenlyInLinearLight) {
  const CueTimeline show = dayToNight();
  const std::vector<Rgb> from = rigFactors(kDay), to = rigFactors(kNight);
  for (const int frame : {26, 49, 72}) {
    const float amount = static_cast<float>(frame - 25) / 48;
    const std::vector<Rgb> now = rigFactors(show.at(frame).rig);
    for (size_t i = 0; i < now.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        const float expected = glm::mix(from[i][c], to[i][c], amount);
        EXPECT_NEAR(now[i][c], expected, 3e-6F * expected) << frame;
      }
    EXPECT_FLOAT_EQ(show.at(frame).rig.ambient, glm::mix(1.F, .25F, amount));
  }
}

TEST(CueTimeline, TimesDoNotDriftAndCutsTakeOneFrame) {
  const std::vector<SavedLook> looks = {{"Day", "", kDay}, {"Night", "", kNight}};
  CueList cues;
  for (int i = 1; i <= 100; ++i) cues.push_back({100 * i, i % 2 ? "Day" : "Night", .1F, .1F});
  const CueTimeline show(cues, looks, {kDay, {}}, {24, .1, 1});
  EXPECT_NEAR(show.lastFrame(), 1 + 24 * (.1 + 99 * .2), 1)
      << "100 holds and 99 fades of a tenth of a second";
  const CueTimeline cut({{100, "Day"}, {200, "Night", 0}}, looks, {kDay, {}}, {24, 0, 1});
  EXPECT_EQ(cut.at(1).rig, kDay);
  EXPECT_EQ(cut.at(2).rig, kNight);
  EXPECT_EQ(cut.lastFrame(), 2);
}

TEST(CueTimeline, KeysSayTheSame) {
  for (const CueTiming& timing : {CueTiming{24, 1, 1}, CueTiming{25, .5, 100}}) {
    const CueTimeline show = dayToNight(timing);
    const RigAnimation keys = show.animation();
    for (int frame = show.firstFrame(); frame <= show.lastFrame(); ++frame) {
      const Rig keyed = rigAt(show.keyedRig(), keys, frame);
      ASSERT_EQ(rigFactors(keyed), rigFactors(show.at(frame).rig)) << frame;
      ASSERT_EQ(keyed.ambient, show.at(frame).rig.ambient) << frame;
    }
    EXPECT_LT(keys.lights.at("key").size(), 60U) << "one a frame of the fade, two a hold";
  }
}

TEST(CueTimeline, KeysNeedNoGroupsSoloOrMute) {
  Rig grouped = kDay;
  grouped.groups = {{"warm", 1, true}, {"off", 0, false}};
  grouped.lights[0].group = "warm";
  grouped.lights[1].mute = true;
  Rig solo = kNight;
  solo.lights[1].solo = true;
  const CueTimeline show({{100, "A"}, {200, "B", 1}}, {{"A", "", grouped}, {"B", "", solo}}, {kDay, {}}, {});
  const RigAnimation keys = show.animation();
  for (int frame = show.firstFrame(); frame <= show.lastFrame(); ++frame) {
    const std::vector<Rgb> keyed = rigFactors(rigAt(show.keyedRig(), keys, frame));
    const std::vector<Rgb> shown = rigFactors(show.at(frame).rig);
    for (size_t i = 0; i < shown.size(); ++i)
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(keyed[i][c], shown[i][c], 1e-6F * shown[i][c]) << frame;
  }
}

TEST(CueTimeline, VersionsBringTheirEdits) {
  VersionScene plain, bright;
  bright.edits.append(gain(2));
  bright.edits.newLights = {"window"};
  Rig withWindow = kNight;
  withWindow.lights.push_back(light("window", 1));
  const std::vector<SavedLook> looks = {{"Day", "", kDay, plain}, {"Night", "", withWindow, bright}};
  const CueTimeline show({{100, "Day"}, {200, "Night", 1}, {300, "Day", 1}}, looks, {kDay, {}}, {10, 1, 0});
  EXPECT_TRUE(show.editsChange());
  const Stage half = show.at(show.places()[1].begins + 5);
  ASSERT_EQ(half.edits.edits.size(), 1U);
  EXPECT_FLOAT_EQ(half.edits.edits[0]->opacity, .5F);
  EXPECT_EQ(half.edits.newLights, bright.edits.newLights);
  ASSERT_EQ(half.rig.lights.size(), 3U);
  EXPECT_NEAR(rigFactors(half.rig)[2].g, 1, 1e-5F)
      << "half of one stop up: a light that comes out of the dark";
  EXPECT_EQ(show.at(show.places()[1].stands).rig.lights.size(), 3U);
  EXPECT_EQ(show.at(show.lastFrame()), (Stage{kDay, {}}));
  EXPECT_EQ(show.keyedRig().lights.size(), 3U);
}

TEST(CueTimeline, SaysWhatCannotBePlayed) {
  const std::vector<SavedLook> looks = {{"Day", "", kDay}};
  const auto said = [&](const CueList& cues, const CueTiming& timing) -> std::string {
    try {
      const CueTimeline show(cues, looks, {kDay, {}}, timing);
    } catch (const InputError& error) {
      return error.what();
    }
    return "(nothing)";
  };
  EXPECT_THAT(said({}, {}), HasSubstr("the cue list is empty"));
  EXPECT_THAT(said({{100, "Night"}}, {}), HasSubstr("cue 1: the gallery has no look \"Night\""));
  EXPECT_THAT(said({{100, "Day"}}, {0, 1, 1}), HasSubstr("frames a second"));
  EXPECT_THAT(said({{100, "Day"}}, {24, -1, 1}), HasSubstr("a hold of -1 s"));
  EXPECT_THAT(said({{100, "Day"}, {200, "Day", 3600}}, {1000, 1, 1}), HasSubstr("longer than"));
}

}  // namespace
}  // namespace swaplight
