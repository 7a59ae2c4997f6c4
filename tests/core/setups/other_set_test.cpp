#include "core/setups/other_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/setups/place_free_edits.h"

namespace swaplight {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Edit editOf(const std::string& name, std::vector<std::string> lights, Operation operation, Mask mask = {}) {
  Edit edit;
  edit.name = name;
  edit.lights = std::move(lights);
  edit.energy = EnergyMode::Add;
  edit.operation = std::move(operation);
  edit.mask = std::move(mask);
  return edit;
}

std::vector<std::string> namesOf(const EditStack& stack) {
  std::vector<std::string> names;
  for (const auto& edit : stack.edits) names.push_back(edit->name);
  return names;
}

TEST(PlaceFreeEdits, WhatHasAPlaceInThePictureStaysThere) {
  const Mask allShadows = {{ShadowShape{"key"}, false}};
  const Mask oneShadow = {{ShadowShape{"key", true, 3, 4}, false}};
  const auto selection = [](const Mask& of) {
    const std::vector<SelectionPart> parts = {{of.front()}};
    return Mask{{SelectionShape{std::make_shared<const std::vector<SelectionPart>>(parts), 2}, false}};
  };
  EditStack stack;
  stack.append(editOf("brighter", {"key"}, GainOperation{2, 0}));
  stack.append(editOf("all lights", {}, CurveOperation{}));
  stack.append(editOf("rectangle", {"key"}, FillOperation{1}, {{RectangleShape{1, 2, 3, 4, 0}, false}}));
  stack.append(editOf("shadows", {"key"}, FillOperation{1}, allShadows));
  stack.append(editOf("one shadow", {"key"}, FillOperation{1}, oneShadow));
  stack.append(editOf("selected shadows", {"key"}, FillOperation{1}, selection(allShadows)));
  stack.append(editOf("selected shadow", {"key"}, FillOperation{1}, selection(oneShadow)));
  stack.append(editOf("beta", {"key"}, BetaMapOperation{"beta.exr", ""}));
  stack.append(editOf("moved", {"key"}, MoveOperation{}));
  stack.append(editOf("placed", {"key"}, PlaceOperation{}));
  stack.append(editOf("other lamp", {"rim"}, FillOperation{0}));
  stack.append(editOf("both", {"key", "rim"}, FillOperation{0}));
  Edit off = editOf("off", {"rim"}, FillOperation{0});
  off.on = false;
  stack.append(off);
  stack.shadowThresholds = {{"key", 0.1F}, {"rim", 0.2F}};
  stack.shadowMarks["key"] = {{ShadowMark::Kind::Lit, 3, 4}};
  stack.lampPlaces["key"] = {};
  const PlaceFreeEdits here = placeFreeEdits(stack, {"key", "fill"});
  EXPECT_THAT(namesOf(here.edits),
              ElementsAre("brighter", "all lights", "shadows", "selected shadows", "both"));
  EXPECT_THAT(here.leftOut,
              ElementsAre("rectangle", "one shadow", "selected shadow", "beta", "moved", "placed",
                          "other lamp", "where its lamps stood", "what is said of single shadows"))
      << "what was off is not missed";
  EXPECT_THAT(here.edits.edits.back()->lights, ElementsAre("key"));
  EXPECT_EQ(here.edits.shadowThresholds.size(), 1u);
  EXPECT_TRUE(here.edits.shadowMarks.empty());
  EXPECT_TRUE(here.edits.lampPlaces.empty());
}

TEST(PlaceFreeEdits, ANewLightStaysWhereAnEditOfItDoes) {
  EditStack stack;
  stack.newLights = {"wash", "spot", "key"};
  stack.append(editOf("wash", {"wash"}, FillOperation{0.5F}));
  stack.append(editOf("spot", {"spot"}, FillOperation{1}, {{EllipseShape{1, 2, 3, 4, 0}, false}}));
  stack.append(editOf("painted key", {"key"}, FillOperation{1}));
  const PlaceFreeEdits here = placeFreeEdits(stack, {"key", "fill"});
  EXPECT_THAT(here.edits.newLights, ElementsAre("wash"));
  EXPECT_THAT(namesOf(here.edits), ElementsAre("wash")) << "its key is not this lamp";
}

TEST(OtherSet, LightsAreFoundByTheirNamesInTheGalleryToo) {
  Capture wide, close;
  wide.lights = {{"key", Role::Key}, {"fill", Role::Fill}, {"rim", Role::Back}};
  close.lights = {{"fill", Role::Fill}, {"key", Role::Key}, {"lamp", Role::Practical}};
  Document document;
  document.source = "/wide.exr";
  document.rig = defaultRig(wide);
  findLight(document.rig, "key").stops = -1;
  document.selection = {{RectangleShape{1, 2, 3, 4, 0}, false}};
  document.cues = {{1, "Night"}};
  SavedLook night{"Night", "late", document.rig};
  findLight(night.rig, "fill").on = false;
  night.scene.emplace();
  night.scene->display.view = "Hable";
  night.scene->edits.append(editOf("word", {"key"}, FillOperation{1}, {{TextShape{}, false}}));
  night.scene->edits.append(editOf("dim", {"key"}, GainOperation{0.5F, 0}));
  document.looks = {night, {"Plain", "", document.rig}};
  const auto [other, notes, complete] = documentForSet(document, "/close.exr", close);
  EXPECT_FALSE(complete);
  EXPECT_EQ(other.source, "/close.exr");
  EXPECT_THAT(other.selection, IsEmpty());
  EXPECT_EQ(other.cues, document.cues);
  ASSERT_EQ(other.rig.lights.size(), 3u);
  EXPECT_EQ(other.rig.lights[1].light, "key");
  EXPECT_EQ(other.rig.lights[1].stops, -1);
  ASSERT_EQ(other.looks.size(), 2u);
  EXPECT_FALSE(other.looks[0].rig.lights[0].on);
  EXPECT_EQ(other.looks[0].note, "late");
  EXPECT_EQ(other.looks[0].scene->display.view, "Hable");
  EXPECT_THAT(namesOf(other.looks[0].scene->edits), ElementsAre("dim"));
  EXPECT_EQ(other.looks[1].rig.lights[2].light, "lamp");
  EXPECT_THAT(notes, ElementsAre("not in this set, left out: rim", "only in this set, as captured: lamp",
                                 "Night: light edits of the other picture are left out: word"));
}

TEST(OtherSet, AllOfALightingWithoutPlacedEditsComesAlong) {
  Capture wide, close;
  wide.lights = {{"key", Role::Key}, {"fill", Role::Fill}};
  close.lights = {{"fill", Role::Fill}, {"key", Role::Key}, {"lamp", Role::Practical}};
  Document document;
  document.rig = defaultRig(wide);
  document.edits.append(editOf("dim", {"key"}, GainOperation{0.5F, 0}));
  EXPECT_TRUE(documentForSet(document, "/close.exr", close).complete);
  document.edits.append(editOf("word", {"key"}, FillOperation{1}, {{TextShape{}, false}}));
  EXPECT_FALSE(documentForSet(document, "/close.exr", close).complete);
}

TEST(OtherSet, ASetOfOtherLightsIsRefused) {
  Capture wide, kitchen;
  wide.lights = {{"key", Role::Key}, {"fill", Role::Fill}};
  kitchen.lights = {{"window", Role::Other}, {"lamp", Role::Practical}};
  Document document;
  document.rig = defaultRig(wide);
  try {
    static_cast<void>(documentForSet(document, "/kitchen.exr", kitchen));
    ADD_FAILURE() << "it was taken";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "/kitchen.exr: its lights are window, lamp, none of which is among key, fill. Choose a set of the "
        "same lights.");
  }
}

}  // namespace
}  // namespace swaplight
