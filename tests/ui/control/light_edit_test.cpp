#include "ui/control/light_edit.h"

#include <gmock/gmock.h>

#include "tests/support/studio_parts.h"
#include "ui/control/look_edit.h"
#include "ui/control/shadow_edit.h"

namespace swaplight {
namespace {

using test::StudioParts;
using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<LightSetting>& lights(const StudioParts& studio) {
  return studio.editor.document().rig.lights;
}

TEST(LightEdit, TheShownLightIsAlwaysOneOfTheRig) {
  StudioParts studio;
  studio.open(test::smallSet(3, 8, 8));
  studio.view.selectedLight = 1;
  EXPECT_EQ(shownLight(studio.chosen), 1U);
  studio.view.selectedLight = 9;
  EXPECT_EQ(shownLight(studio.chosen), 2U);
  studio.view.selectedLight = -1;
  EXPECT_EQ(shownLight(studio.chosen), 0U);
}

TEST(LightEdit, AChangeOfAChosenLightIsForAllThatAreChosen) {
  StudioParts studio;
  studio.open(test::smallSet(4, 8, 8));
  studio.view.selectedLights = {0, 2, 17};  // the last one is of another session
  EXPECT_THAT(lightsFor(studio.chosen, 2), ElementsAre(0U, 2U));
  EXPECT_THAT(lightsFor(studio.chosen, 1), ElementsAre(1U));
  editLights(studio.chosen, 2, "mute", [](LightSetting& light) { light.mute = true; });
  EXPECT_TRUE(lights(studio)[0].mute && lights(studio)[2].mute);
  EXPECT_FALSE(lights(studio)[1].mute || lights(studio)[3].mute);
  EXPECT_EQ(studio.editor.history().steps().back().name, "2 lights: mute");
  studio.editor.undo();
  EXPECT_FALSE(lights(studio)[0].mute || lights(studio)[2].mute) << "one step for all of them";
}

TEST(LightEdit, AGestureIsOneStep) {
  StudioParts studio;
  studio.open(test::smallSet(2, 8, 8));
  const size_t before = studio.editor.history().steps().size();
  for (int i = 1; i <= 5; ++i) previewStops(studio.chosen, 0, 0.1F);
  EXPECT_TRUE(studio.editor.inGesture());
  EXPECT_NEAR(lights(studio)[0].stops, 0.5F, 1e-5F);
  studio.editor.commit();
  EXPECT_EQ(studio.editor.history().steps().size(), before + 1);
}

TEST(LightEdit, SoloAloneTakesTheOthersSoloAway) {
  StudioParts studio;
  studio.open(test::smallSet(3, 8, 8));
  toggleSolo(studio.chosen, 0, false);
  toggleSolo(studio.chosen, 1, false);
  EXPECT_TRUE(lights(studio)[0].solo && lights(studio)[1].solo);
  toggleSolo(studio.chosen, 2, true);
  EXPECT_FALSE(lights(studio)[0].solo || lights(studio)[1].solo);
  EXPECT_TRUE(lights(studio)[2].solo);
  toggleSolo(studio.chosen, 2, false);
  EXPECT_FALSE(lights(studio)[2].solo);
}

// Looks.

StudioParts& withRoles(StudioParts& studio) {
  SolvedSet set = test::smallSet(3, 24, 16);
  set.capture.lights[0].role = Role::Key;
  set.capture.lights[1].role = Role::Fill;
  set.capture.lights[2].role = Role::Back;
  studio.open(std::move(set));
  return studio;
}

TEST(LookEdit, APresetCanBeBlendedUntilSomethingElseChanges) {
  StudioParts studio;
  withRoles(studio);
  const Rig before = studio.editor.document().rig;
  applyPreset(studio.lights, findLook("low key"));
  const Rig whole = studio.editor.document().rig;
  EXPECT_NE(whole, before);
  ASSERT_NE(activeBlend(studio.lights), nullptr);
  previewBlend(studio.lights, 0);
  EXPECT_EQ(rigFactors(studio.editor.document().rig), rigFactors(before));
  previewBlend(studio.lights, 1);
  EXPECT_EQ(rigFactors(studio.editor.document().rig), rigFactors(whole));
  studio.editor.commit();
  // Another preset is over what was before the first one.
  applyPreset(studio.lights, findLook("high key"));
  ASSERT_NE(activeBlend(studio.lights), nullptr);
  EXPECT_EQ(activeBlend(studio.lights)->before, before);
  toggleSolo(studio.chosen, 0, false);
  EXPECT_EQ(activeBlend(studio.lights), nullptr);
}

TEST(LookEdit, APresetWithoutAKeyLightSaysWhy) {
  StudioParts studio;
  studio.open(test::smallSet(2, 24, 16));
  const Rig before = studio.editor.document().rig;
  applyPreset(studio.lights, findLook("low key"));
  EXPECT_EQ(studio.editor.document().rig, before);
  EXPECT_THAT(studio.said(), HasSubstr("key"));
}

TEST(LookEdit, APresetSaysWhichLightsWithoutARoleItHasChanged) {
  StudioParts studio;
  SolvedSet set = test::smallSet(3, 24, 16);
  set.capture.lights[0].role = Role::Key;
  set.capture.lights[1].role = Role::Fill;
  const std::string name = set.capture.lights[2].name;
  studio.open(std::move(set));
  applyPreset(studio.lights, findLook("neon"));
  EXPECT_THAT(studio.said(), HasSubstr("Neon has changed " + name + ", too, which has no role."));
}

TEST(LookEdit, APresetThatChangesOnlyLightsWithRolesSaysNothing) {
  StudioParts studio;
  withRoles(studio);
  applyPreset(studio.lights, findLook("neon"));
  EXPECT_EQ(studio.said(), "");
}

TEST(LookEdit, LooksAreKeptRecalledAndCrossfaded) {
  StudioParts studio;
  withRoles(studio);
  keepLook(studio.lights);
  editLights(studio.chosen, 0, "brighter", [](LightSetting& light) { light.stops = 2; });
  keepLook(studio.lights);
  const std::vector<SavedLook> looks = studio.editor.document().looks;
  ASSERT_EQ(looks.size(), 2U);
  EXPECT_NE(looks[0].name, looks[1].name);
  recallLook(studio.lights, looks[0]);
  EXPECT_EQ(lights(studio)[0].stops, 0);
  previewCrossfade(studio.lights, looks[0], looks[1], 1);
  EXPECT_EQ(rigFactors(studio.editor.document().rig), rigFactors(looks[1].rig));
  studio.editor.commit();
  wipeAgainstLook(studio.lights, looks[0]);
  EXPECT_EQ(studio.view.compare.mode, CompareState::Mode::Wipe);
  EXPECT_EQ(studio.view.compare.rig, looks[0].rig);
}

TEST(LookEdit, RatiosAreMeasuredAgainForAnotherSet) {
  StudioParts studio;
  withRoles(studio);
  static_cast<void>(lightRatios(studio.lights));
  const uint64_t first = studio.looks.ratiosOfSet;
  static_cast<void>(lightRatios(studio.lights));
  EXPECT_EQ(studio.looks.ratiosOfSet, first);
  studio.open(test::smallSet(2, 24, 16));
  static_cast<void>(lightRatios(studio.lights));
  EXPECT_NE(studio.looks.ratiosOfSet, first);
}

// Shadows.

TEST(ShadowEdit, ThePageIsSeenOnlyWhereItHasARoom) {
  StudioParts studio;
  studio.open(test::discSet());
  EXPECT_FALSE(shadowsShown(studio.editingContext));
  studio.layout.shadows = studio.layout.edits = true;
  EXPECT_TRUE(shadowsShown(studio.editingContext));
  constexpr Tool tool{"tool.take", "A tool", "", "", true};
  studio.tool = &tool;
  EXPECT_FALSE(shadowsShown(studio.editingContext)) << "a tool that edits has a page of its own";
  studio.tool = nullptr;
  studio.layout.hidden = true;
  EXPECT_FALSE(shadowsShown(studio.editingContext));
}

TEST(ShadowEdit, ThresholdsAreGivenAndTakenBack) {
  StudioParts studio;
  studio.open(test::discSet());
  EXPECT_FALSE(shadowThresholdOf(studio.editor.document(), "key"));
  previewShadowThreshold(studio.editingContext, "key", -2);
  previewShadowThreshold(studio.editingContext, "key", -1);
  EXPECT_EQ(shadowThresholdOf(studio.editor.document(), "key"), -1);
  studio.editor.commit();
  resetShadowThreshold(studio.editingContext, "key");
  EXPECT_FALSE(shadowThresholdOf(studio.editor.document(), "key"));
  studio.editor.undo();
  EXPECT_EQ(shadowThresholdOf(studio.editor.document(), "key"), -1);
}

TEST(ShadowEdit, PlacesAreLabelledAndTheSameClickTakesTheLabelBack) {
  using Kind = ShadowMark::Kind;
  StudioParts studio;
  studio.open(test::discSet());
  const auto marks = [&] { return shadowMarksOf(studio.editor.document(), "key"); };
  const auto& context = studio.editingContext;
  markShadow(context, "key", {Kind::Lit, 80, 60}, 5);
  markShadow(context, "key", {Kind::Shadow, 20, 20}, 5);
  EXPECT_EQ(marks(), (ShadowMarks{{Kind::Lit, 80, 60}, {Kind::Shadow, 20, 20}}));
  EXPECT_EQ(studio.editor.history().steps().back().name, "Shadows of key: this is shadow");
  EXPECT_TRUE(shadowMarksOf(studio.editor.document(), "fill").empty());
  markShadow(context, "key", {Kind::Shadow, 82, 61}, 5);  // near the first: it says something else now
  EXPECT_EQ(marks(), (ShadowMarks{{Kind::Shadow, 20, 20}, {Kind::Shadow, 82, 61}}));
  markShadow(context, "key", {Kind::Shadow, 21, 22}, 5);  // the same of the same place: taken back
  EXPECT_EQ(marks(), (ShadowMarks{{Kind::Shadow, 82, 61}}));
  clearShadowMarks(context, "key");
  EXPECT_TRUE(studio.editor.document().edits.shadowMarks.empty());
  const size_t steps = studio.editor.history().steps().size();
  clearShadowMarks(context, "key");
  EXPECT_EQ(studio.editor.history().steps().size(), steps) << "nothing to clear";
  for (int i = 0; i < 5; ++i) studio.editor.undo();
  EXPECT_TRUE(marks().empty());
}

TEST(ShadowEdit, ASlidersEditComesChangesAndGoes) {
  using Kind = ShadowOperation::Kind;
  StudioParts studio;
  studio.open(test::discSet());
  const ShadowKinds kinds = {Kind::Lighten, Kind::Deepen};
  EXPECT_EQ(shadowEdit(studio.editingContext, "key", kinds), -1);
  EXPECT_EQ(shadowOperation(studio.editingContext, "key", kinds).amount, 0);
  const auto give = [&](const ShadowOperation& operation) {
    studio.editor.edit("Shadow", withShadowOperation(studio.editingContext, "key", kinds, operation));
  };
  give({Kind::Lighten, 0.5F, 12, {1, 1, 1}});
  ASSERT_EQ(shadowEdit(studio.editingContext, "key", kinds), 0);
  EXPECT_EQ(shadowEdit(studio.editingContext, "fill", kinds), -1);
  give({Kind::Deepen, 0.25F, 12, {1, 1, 1}});
  ASSERT_EQ(studio.editor.document().edits.edits.size(), 1U);
  EXPECT_EQ(shadowOperation(studio.editingContext, "key", kinds).kind, Kind::Deepen);
  give({Kind::Deepen, 0, 12, {1, 1, 1}});
  EXPECT_TRUE(studio.editor.document().edits.edits.empty());
}

TEST(ShadowEdit, AChosenShadowHasAnEditOfItsOwn) {
  using Kind = ShadowOperation::Kind;
  StudioParts studio;
  studio.open(test::discSet());
  const ShadowKinds kinds = {Kind::Lighten};
  const ShadowOperation half{Kind::Lighten, 0.5F, 12, {1, 1, 1}};
  studio.editor.edit("All", withShadowOperation(studio.editingContext, "key", kinds, half));
  ConnectedShadow one;
  one.x = 80;
  one.y = 60;
  studio.editing.shadow.chosen = one;
  studio.editing.shadow.light = "key";
  EXPECT_EQ(shadowEdit(studio.editingContext, "key", kinds), -1) << "all shadows' edit is not this one's";
  studio.editor.edit("One", withShadowOperation(studio.editingContext, "key", kinds, half));
  ASSERT_EQ(studio.editor.document().edits.edits.size(), 2U);
  const Mask& mask = studio.editor.document().edits.edits[1]->mask;
  ASSERT_EQ(mask.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<ShadowShape>(mask.front().shape));
}

}  // namespace
}  // namespace swaplight
