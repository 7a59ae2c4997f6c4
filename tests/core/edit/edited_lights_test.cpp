#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/edit/apply/edited_set.h"
#include "tests/support/small_set.h"

namespace swaplight {
namespace {

constexpr int kWidth = 280;  // more than a tile
constexpr int kHeight = 40;
constexpr int kLights = 4;

/// With ambient light and highlights.
std::shared_ptr<const SolvedSet> glossySet() {
  SolvedSet set = test::smallSet(kLights, kWidth, kHeight);
  set.ambient = Image(ImageSpec::rgb(kWidth, kHeight), .05F);
  for (const Image& light : set.contributions) {
    Image& highlight = set.highlights.emplace_back(light.clone());
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < highlight.pixelCount(); ++p)
        highlight.plane(c)[p] *= .5F * static_cast<float>(p % 3);
  }
  keepHighlightsInLights(set);
  return std::make_shared<const SolvedSet>(std::move(set));
}

Edit editOf(const std::vector<std::string>& lights, Operation operation,
            EnergyMode energy = EnergyMode::Add) {
  Edit edit;
  edit.name = "test";
  edit.lights = lights;
  edit.operation = std::move(operation);
  edit.energy = energy;
  return edit;
}

EditStack stackOf(const std::vector<Edit>& edits) {
  EditStack stack;
  for (const Edit& edit : edits) stack.append(edit);
  return stack;
}

float largestDifference(const std::vector<Image>& a, const std::vector<Image>& b) {
  float largest = 0;
  for (size_t i = 0; i < a.size(); ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < a[i].pixelCount(); ++p)
        largest = std::max(largest, std::abs(a[i].plane(c)[p] - b[i].plane(c)[p]));
  return largest;
}

/// The same stack with an edit more, at the bottom.
EditStack withBelow(const EditStack& stack, const Edit& edit) {
  EditStack more = stackOf({edit});
  more.edits.insert(more.edits.end(), stack.edits.begin(), stack.edits.end());
  return more;
}

EditStack withAbove(EditStack stack, const Edit& edit) {
  stack.append(edit);
  return stack;
}

/// The lights that are computed again when the second stack follows the first.
LightIndices computedAgain(const EditStack& before, const EditStack& after) {
  EditedSet edited(glossySet());
  edited.setStack(before);
  edited.update();
  EXPECT_TRUE(edited.staleLights().empty());
  edited.setStack(after);
  return edited.staleLights();
}

/// Any edit that needs no file and no shadows, on any lights, anywhere.
Edit anyEdit(std::mt19937& random) {
  const auto upTo = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
  const auto part = [&] { return static_cast<float>(upTo(100)) / 100; };
  const std::vector<Operation> operations = {
      FillOperation{part()},
      GainOperation{2 * part(), .2F * part()},
      InvertOperation{},
      BlurOperation{3},
      SharpenOperation{3, part()},
      CurveOperation{{{0, 0}, {.5F, part()}, {1, 1}}},
      MoveOperation{.1F * part()},
      TurnOperation{10 * part()},
      SpreadOperation{.5F + part()},
      ShineOperation{3 * part()},
      RecolorOperation{RecolorOperation::Kind::Shift, 90 * part(), 1, 1, Rgb(1), Rgb(1)}};
  Edit edit = editOf({}, operations[static_cast<size_t>(upTo(static_cast<int>(operations.size())))],
                     upTo(2) ? EnergyMode::Add : EnergyMode::Redistribute);
  if (!actsOnAllLights(edit.operation) && upTo(4) != 0)
    for (int light = 1; light <= kLights; ++light)
      if (upTo(2)) edit.lights.push_back("light" + std::to_string(light));
  if (upTo(2)) edit.mask = {{EllipseShape{280 * part(), 40 * part(), 60, 20, 10}, upTo(4) == 0}};
  edit.opacity = .25F + .75F * part();
  edit.on = upTo(8) != 0;
  return edit;
}

TEST(EditedLights, ALightsOwnEditLeavesTheOthersWhereTheyAre) {
  EXPECT_EQ(computedAgain({}, stackOf({editOf({"light2"}, FillOperation{0})})), LightIndices{1});
  EXPECT_EQ(computedAgain({}, stackOf({editOf({"light1", "light4"}, MoveOperation{.1F})})),
            (LightIndices{0, 3}));
  const EditStack stack = stackOf({editOf({"light3"}, GainOperation{.5F, 0})});
  EXPECT_EQ(computedAgain(stack, withAbove(stack, editOf({"light2"}, ShineOperation{2}))), LightIndices{1});
}

TEST(EditedLights, OneThatSharesChangesAll) {
  const EditStack shares = stackOf({editOf({"light2"}, FillOperation{.5F}, EnergyMode::Redistribute)});
  const Edit adds = editOf({"light3"}, FillOperation{.5F});
  EXPECT_EQ(computedAgain({}, shares), allLights(kLights));
  EXPECT_EQ(computedAgain(shares, {}), allLights(kLights));
  EXPECT_EQ(computedAgain(shares, withBelow(shares, adds)), allLights(kLights))
      << "what it shares has changed";
}

TEST(EditedLights, LightsThatChangePlacesAreTied) {
  const EditStack swaps = stackOf({editOf({"light1", "light2"}, InvertOperation{})});
  const Edit adds = editOf({"light2"}, FillOperation{.5F});
  const Edit other = editOf({"light3"}, FillOperation{.5F});
  EXPECT_EQ(computedAgain(swaps, withBelow(swaps, adds)), (LightIndices{0, 1}));
  EXPECT_EQ(computedAgain(swaps, withBelow(swaps, other)), LightIndices{2});
}

TEST(EditedLights, EditsThatAreOffChangeAndTieNothing) {
  Edit off = editOf({"light2"}, FillOperation{.5F}, EnergyMode::Redistribute);
  off.on = false;
  const EditStack stack = stackOf({off});
  EXPECT_TRUE(computedAgain({}, stack).empty());
  EXPECT_EQ(computedAgain(stack, withAbove(stack, editOf({"light1"}, FillOperation{0}))), LightIndices{0});
}

TEST(EditedLights, WhatWasNotComputedYetIsNotForgotten) {
  const auto set = glossySet();
  EditedSet edited(set);
  edited.update();
  const Edit first = editOf({"light1"}, FillOperation{0});
  edited.setStack(stackOf({first}));
  edited.update({0, 0, 10, 10});  // one tile of two
  EditStack both = edited.stack();
  both.append(editOf({"light3"}, FillOperation{1}));
  edited.setStack(both);
  EXPECT_EQ(edited.staleLights(), (LightIndices{0, 2}));
  edited.update();
  EXPECT_LT(largestDifference(edited.result().contributions, applyEdits(*set, both).contributions), 2e-6F);
}

TEST(EditedLights, AnyChangeOfAnyStackGivesWhatTheReferenceGives) {
  const auto set = glossySet();
  EditedSet edited(set);
  EditStack stack;
  for (unsigned seed = 1; seed <= 120; ++seed) {
    std::mt19937 random(seed);
    const size_t place = stack.edits.empty() ? 0 : random() % stack.edits.size();
    if (stack.edits.size() < 2 || random() % 3 == 0)
      stack.append(anyEdit(random));
    else if (stack.edits.size() > 6 || random() % 3 == 0)
      stack.edits.erase(stack.edits.begin() + static_cast<ptrdiff_t>(place));
    else
      stack.replace(place, anyEdit(random));
    edited.setStack(stack);
    if (random() % 3 == 0)
      edited.update({0, 0, 100, 40});
    else
      edited.update();
    if (edited.staleTile()) continue;
    const SolvedSet reference = applyEdits(*set, stack);
    ASSERT_LT(largestDifference(edited.result().contributions, reference.contributions), 1e-5F) << seed;
    ASSERT_LT(largestDifference(edited.result().highlights, reference.highlights), 1e-5F) << seed;
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < reference.ambient->pixelCount(); ++p)
        ASSERT_NEAR(edited.result().ambient->plane(c)[p], reference.ambient->plane(c)[p], 1e-6F) << seed;
  }
}

TEST(EditedLights, ANewLightThrowsNoShadowsAndHasNoLamp) {
  const auto set = glossySet();
  auto shadows = std::make_shared<LightShadows>();
  shadows->visibility = Image(ImageSpec{kWidth, kHeight, {"Y"}, "data"}, 1);
  shadows->direct = Image(ImageSpec::rgb(kWidth, kHeight), 1);
  shadows->labels.assign(size_t(kWidth) * kHeight, ShadowLabel::Lit);
  const ShadowSource source = [&](const std::string& light) {
    EXPECT_NE(light, "moon");
    return shadows;
  };
  for (const bool all : {true, false})
    for (const Operation& operation : {Operation(ShadowOperation{}), Operation(MoveOperation{.1F, 0})}) {
      Edit edit = editOf({}, operation);
      if (!all) edit.lights = {"moon"};
      EditStack stack = stackOf({edit});
      stack.newLights = {"moon"};
      const SolvedSet edited = applyEdits(*set, stack, source);
      for (int c = 0; c < 3; ++c) EXPECT_EQ(edited.contributions.back().plane(c)[7], 0);
      if (all) continue;
      EXPECT_THAT(edited.capture.warnings, testing::Contains(testing::HasSubstr("not photographed")));
    }
}

TEST(EditedLights, NewLightsAreNamedAsLightsAre) {
  const auto set = glossySet();
  const std::string first = set->capture.lights[0].name;
  for (const std::vector<std::string>& names :
       std::vector<std::vector<std::string>>{{""}, {"my moon"}, {"ambient"}, {"moon.R"}, {"1x"}, {first}}) {
    EditStack stack;
    stack.newLights = names;
    EXPECT_THROW(static_cast<void>(applyEdits(*set, stack)), InputError) << names.front();
  }
}

}  // namespace
}  // namespace swaplight
