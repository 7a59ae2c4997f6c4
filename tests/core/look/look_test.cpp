#include "core/look/look.h"
#include "core/look/look_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/look/rig_blend.h"
#include "core/look/saved_look.h"
#include "core/look/three_point.h"
#include "core/relight/relight.h"
#include "core/relight/setting.h"
#include "tests/support/small_set.h"

namespace swaplight {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Three lights whose contributions are constant on a textured surface, so that their ratios are known.
struct KnownSet {
  SolvedSet set;
  Rig rig;
  LightRatios ratios;

  explicit KnownSet(const std::vector<float>& strengths) {
    set = test::smallSet(static_cast<int>(strengths.size()), 40, 30);
    const Image texture = set.contributions[0].clone();
    for (size_t i = 0; i < strengths.size(); ++i)
      for (int c = 0; c < 3; ++c)
        for (size_t p = 0; p < texture.pixelCount(); ++p)
          set.contributions[i].plane(c)[p] = strengths[i] * texture.plane(c)[p];
    updateBeta(set);
    const Role roles[] = {Role::Key, Role::Fill, Role::Back, Role::Practical};
    for (size_t i = 0; i < strengths.size(); ++i) set.capture.lights[i].role = roles[i];
    rig = defaultRig(set.capture);
    ratios = LightRatios(set);
  }
};

Rgb pixel(const Image& frame, int x, int y) {
  return {frame.view().at(0, x, y), frame.view().at(1, x, y), frame.view().at(2, x, y)};
}

TEST(LightRatios, AreTheStopsBetweenLightsWhereTheyMeet) {
  const KnownSet known({1, 0.25F, 0.5F});
  EXPECT_NEAR(known.ratios.stops(0, 1), 2, 1e-4);
  EXPECT_NEAR(known.ratios.stops(1, 0), -2, 1e-4);
  EXPECT_NEAR(known.ratios.stops(1, 2), -1, 1e-4);
  EXPECT_EQ(known.ratios.stops(2, 2), 0);
}

TEST(LightRatios, CompareLightsThatDoNotMeetByTheirMeans) {
  SolvedSet set = KnownSet({1, 1}).set;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < set.beta.pixelCount(); ++p) {
      set.contributions[0].plane(c)[p] = p % 2 == 0 ? 0.8F : 0;
      set.contributions[1].plane(c)[p] = p % 2 == 0 ? 0 : 0.2F;
    }
  EXPECT_NEAR(LightRatios(set).stops(0, 1), 2, 1e-3);
}

TEST(ThreePoint, TheRatioIsSetAndReadBack) {
  const KnownSet known({1, 0.25F, 0.5F});
  EXPECT_NEAR(*stopsOverRole(known.rig, known.ratios, Role::Key, Role::Fill), 2, 1e-4);
  const Rig rig = withStopsOverRole(known.rig, known.ratios, Role::Fill, Role::Key, -3);
  EXPECT_NEAR(*stopsOverRole(rig, known.ratios, Role::Key, Role::Fill), 3, 1e-4);
  EXPECT_NEAR(rig.lights[1].stops, -1, 1e-4);
  EXPECT_EQ(rig.lights[0], known.rig.lights[0]);
  EXPECT_EQ(rig.lights[2], known.rig.lights[2]);
}

TEST(ThreePoint, TheRatioIsWhatTheFrameShows) {
  const KnownSet known({1, 0.7F, 0.5F});
  Rig rig = known.rig;
  applySetting(rig.lights[0], "2700K,+0.7st");
  rig = withStopsOverRole(rig, known.ratios, Role::Fill, Role::Key, -2);
  Rig onlyKey = rig, onlyFill = rig;
  onlyKey.lights[0].solo = onlyFill.lights[1].solo = true;
  const auto luminance = [&](const Rig& lit) {
    const Rgb value = pixel(relight(known.set, rigFactors(lit), 1), 20, 15);
    return 0.2126F * value.r + 0.7152F * value.g + 0.0722F * value.b;
  };
  // The colours differ, and so does the pixel's own: a ratio by luminance is then true of greys only.
  EXPECT_NEAR(luminance(onlyKey) / luminance(onlyFill), 4, 0.6);
}

TEST(ThreePoint, ASetWithoutARoleHasNoRatio) {
  KnownSet known({1, 0.5F});
  known.rig.lights[1].role = Role::Other;
  EXPECT_FALSE(stopsOverRole(known.rig, known.ratios, Role::Key, Role::Fill));
  EXPECT_EQ(withStopsOverRole(known.rig, known.ratios, Role::Fill, Role::Key, -1), known.rig);
}

TEST(ThreePoint, RatiosAreWrittenAsOnTheSet) {
  EXPECT_EQ(ratioWords(0), "1:1");
  EXPECT_EQ(ratioWords(1), "2:1");
  EXPECT_EQ(ratioWords(1.5F), "2.8:1");
  EXPECT_EQ(ratioWords(4), "16:1");
  EXPECT_EQ(ratioWords(-1), "1:2");
}

TEST(ThreePoint, WarmKeyAndCoolFillAreSoFarApart) {
  const KnownSet known({1, 0.5F});
  for (const float split : {-250.0F, -60.0F, 0.0F, 90.0F, 240.0F}) {
    const Rig rig = withWarmCoolSplit(known.rig, split);
    EXPECT_NEAR(*warmCoolSplit(rig), split, 1.5) << split;
  }
  const Rig warm = withWarmCoolSplit(known.rig, 200);
  EXPECT_LT(warm.lights[0].color.kelvin, 3600);
  EXPECT_GT(warm.lights[1].color.kelvin, 10000);
  Rig magenta = known.rig;
  applySetting(magenta.lights[0], "#ff00ff");
  EXPECT_FALSE(warmCoolSplit(magenta));
}

TEST(BlendRigs, IsADissolveOfTheFrames) {
  const KnownSet known({1, 0.25F, 0.5F, 0.1F});
  Rig a = known.rig, b = known.rig;
  applySetting(a.lights[0], "3200K,+1st");
  applySetting(a.lights[1], "off");
  a.lights[2].group = "rim";
  a.groups = {{"rim", -1, true}};
  applySetting(b.lights[0], "#4060ff,-2st");
  applySetting(b.lights[1], "gel:L201");
  b.lights[3].mute = true;
  b.ambient = 0.5F;
  const Image frameA = relight(known.set, rigFactors(a), 1), frameB = relight(known.set, rigFactors(b), 1);
  for (const float amount : {0.0F, 0.3F, 0.75F, 1.0F}) {
    const Rig blended = blendRigs(a, b, amount);
    const Rgb shown = pixel(relight(known.set, rigFactors(blended), 1), 13, 11);
    const Rgb wanted = (1 - amount) * pixel(frameA, 13, 11) + amount * pixel(frameB, 13, 11);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown[c], wanted[c], 1e-5F + 1e-4F * wanted[c]) << amount;
    EXPECT_NEAR(blended.ambient, 1 - 0.5F * amount, 1e-6);
  }
  EXPECT_EQ(blendRigs(a, b, 0), a);
  EXPECT_EQ(blendRigs(a, b, 1).lights[0], b.lights[0]);
}

TEST(BlendRigs, ALightThatIsOnlyDimmedKeepsItsColour) {
  const KnownSet known({1, 0.5F});
  Rig a = known.rig, b = known.rig;
  applySetting(a.lights[0], "3200K");
  applySetting(b.lights[0], "3200K,-2st");
  applySetting(a.lights[1], "#4060ff");
  applySetting(b.lights[1], "off");
  const Rig blended = blendRigs(a, b, 0.5F);
  EXPECT_EQ(blended.lights[0].color, a.lights[0].color);
  EXPECT_NEAR(blended.lights[0].stops, std::log2(0.625F), 1e-4);
  EXPECT_EQ(blended.lights[1].color, a.lights[1].color);
  EXPECT_NEAR(blended.lights[1].stops, -1, 1e-4);
}

TEST(Look, EveryPresetSuitsThreeLightsAndHasTheRatioThatItNames) {
  const KnownSet known({1, 0.8F, 0.3F, 0.1F});
  for (const Look& look : presetLooks()) {
    const Rig rig = applyLook(known.rig, look, known.ratios);
    EXPECT_NE(rig, known.rig) << look.name;
    EXPECT_FALSE(look.words.empty());
    if (look.fill.level == RoleLook::Level::OverKey) {
      EXPECT_NEAR(*stopsOverRole(rig, known.ratios, Role::Fill, Role::Key), look.fill.stops, 1e-3)
          << look.name;
    }
    if (look.back.level == RoleLook::Level::OverKey) {
      EXPECT_NEAR(*stopsOverRole(rig, known.ratios, Role::Back, Role::Key), look.back.stops, 1e-3)
          << look.name;
    }
  }
  EXPECT_FALSE(applyLook(known.rig, findLook("silhouette"), known.ratios).lights[1].on);
}

TEST(PresetLook, ASilhouetteNeedsLightFromBehindOrOnTheBackground) {
  const KnownSet two({0.6F, 0.2F});
  EXPECT_FALSE(leavesDark(two.rig));
  EXPECT_TRUE(leavesDark(applyLook(two.rig, findLook("silhouette"), two.ratios)));
  const KnownSet three({0.6F, 0.2F, 0.3F});
  EXPECT_FALSE(leavesDark(applyLook(three.rig, findLook("silhouette"), three.ratios)));
  Rig wall = two.rig;
  wall.lights[1].role = Role::Background;
  const Rig against = applyLook(wall, findLook("silhouette"), two.ratios);
  EXPECT_TRUE(against.lights[1].on);
  EXPECT_GT(settingStops(against, 1), settingStops(against, 0) + 6);
}

TEST(Look, TheRatioDoesNotDependOnHowTheLightsWerePhotographed) {
  const KnownSet even({1, 1, 1}), weak({1, 0.1F, 0.2F});
  const Look& look = findLook("Rembrandt");
  const Image a = relight(even.set, rigFactors(applyLook(even.rig, look, even.ratios)), 1);
  const Image b = relight(weak.set, rigFactors(applyLook(weak.rig, look, weak.ratios)), 1);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel(a, 9, 7)[c], pixel(b, 9, 7)[c], 1e-4);
}

TEST(Look, IsFoundByItsNameHoweverItIsWritten) {
  EXPECT_EQ(findLook("day-for-NIGHT").name, "Day for night");
  EXPECT_EQ(findLook("golden_hour").name, "Golden hour");
  EXPECT_THAT([] { static_cast<void>(findLook("noir")); },
              ThrowsMessage<InputError>(HasSubstr("there are: High key, Low key")));
}

TEST(Look, IsAskedForByNameAndAmount) {
  EXPECT_EQ(lookRequestFromText("golden hour").amount, 1);
  EXPECT_FLOAT_EQ(lookRequestFromText("golden-hour:0.6").amount, 0.6F);
  EXPECT_FLOAT_EQ(lookRequestFromText("neon:25%").amount, 0.25F);
  EXPECT_EQ(lookRequestFromText("neon:25%").name, "neon");
  for (const char* wrong : {"neon:", "neon:2", "neon:-1", "neon:half", "neon:0.5x"})
    EXPECT_THROW(static_cast<void>(lookRequestFromText(wrong)), InputError) << wrong;
}

TEST(SavedLook, IsMeantByItsNameOrItsNumber) {
  const std::vector<SavedLook> looks = {{"Night", "", {}}, {"3", "", {}}, {"Late night", "", {}}};
  EXPECT_EQ(placeOfLook(looks, "night"), 0u);
  EXPECT_EQ(placeOfLook(looks, "Late night"), 2u);
  EXPECT_EQ(placeOfLook(looks, "2"), 1u);
  EXPECT_EQ(placeOfLook(looks, "3"), 1u) << "a name goes before a number";
  for (const char* none : {"", "0", "4", "1.5", "Dawn", "-1"}) EXPECT_FALSE(placeOfLook(looks, none)) << none;
}

TEST(SavedLook, ComesBackFromItsFile) {
  const KnownSet known({1, 0.5F});
  std::vector<SavedLook> looks{{"Look 1", "", known.rig}, {"Dawn", "take 3", known.rig}};
  applySetting(looks[1].rig.lights[0], "8000K,-1st");
  EXPECT_EQ(savedLooksFromJson(jsonFromSavedLooks(looks), "looks"), looks);
  EXPECT_EQ(freeLookName(looks), "Look 2");
  EXPECT_EQ(findSavedLook(looks, "dawn"), &looks[1]);
  EXPECT_EQ(findSavedLook(looks, "dusk"), nullptr);
  EXPECT_THAT([] { static_cast<void>(savedLooksFromJson(Json::parse(R"([{"name": "x"}])"), "look")); },
              ThrowsMessage<InputError>(HasSubstr("look 1 (x): \"rig\" is missing")));
}

TEST(Look, NeedsAKeyLight) {
  KnownSet known({1, 0.5F});
  known.rig.lights[0].role = Role::Other;
  EXPECT_THAT([&] { static_cast<void>(applyLook(known.rig, findLook("neon"), known.ratios)); },
              ThrowsMessage<InputError>(HasSubstr("role key")));
}

}  // namespace
}  // namespace swaplight
