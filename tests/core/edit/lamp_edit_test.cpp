#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/edit/apply/edited_set.h"
#include "tests/support/lamp_set.h"
#include "tests/support/small_set.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::smallSet;

constexpr int kWidth = 300;  // more than a tile
constexpr int kHeight = 270;

EditStack stackOf(const Operation& operation, const std::string& light, Mask mask = {}) {
  Edit edit;
  edit.name = "test";
  if (!light.empty()) edit.lights = {light};
  edit.energy = EnergyMode::Add;
  edit.operation = operation;
  edit.mask = std::move(mask);
  EditStack stack;
  stack.append(edit);
  return stack;
}

// Of each kind, some far and strong.
std::vector<Operation> lampOperations() {
  return {MoveOperation{.1F, -.05F, .8F}, MoveOperation{-2, 2, .25F}, TurnOperation{20, -10},
          TurnOperation{-90, 90},         SpreadOperation{.25F},      SpreadOperation{3}};
}

void expectSameBits(const SolvedSet& a, const SolvedSet& b) {
  for (size_t i = 0; i < a.contributions.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const Image& x = a.contributions[i];
      ASSERT_TRUE(std::equal(x.plane(c), x.plane(c) + x.pixelCount(), b.contributions[i].plane(c)))
          << "light " << i;
    }
}

float largestDifference(const Image& a, const Image& b) {
  float largest = 0;
  for (int c = 0; c < a.channelCount(); ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p)
      largest = std::max(largest, std::abs(a.plane(c)[p] - b.plane(c)[p]));
  return largest;
}

SolvedSet scaled(SolvedSet set, float factor) {
  for (Image& light : set.contributions)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < light.pixelCount(); ++p) light.plane(c)[p] *= factor;
  return set;
}

TEST(LampEdit, NeutralValuesGiveTheSameBits) {
  const SolvedSet set = smallSet(3, kWidth, kHeight);
  for (const Operation& operation :
       {Operation(MoveOperation{}), Operation(TurnOperation{}), Operation(SpreadOperation{}),
        Operation(SizeOperation{}), Operation(SizeOperation{1, .5F})})
    expectSameBits(applyEdits(set, stackOf(operation, "")), set);
}

TEST(LampEdit, LeavesTheOtherLightsAloneToTheBit) {
  const SolvedSet set = smallSet(3, kWidth, kHeight);
  for (const Operation& operation : lampOperations()) {
    const SolvedSet edited = applyEdits(set, stackOf(operation, "light2"));
    EXPECT_EQ(largestDifference(edited.contributions[0], set.contributions[0]), 0);
    EXPECT_EQ(largestDifference(edited.contributions[2], set.contributions[2]), 0);
    EXPECT_GT(largestDifference(edited.contributions[1], set.contributions[1]), .005F)
        << operationName(operation);
  }
}

TEST(LampEdit, IsFiniteAndNeverNegative) {
  for (const int lights : {1, 2}) {
    SolvedSet set = smallSet(lights, kWidth, kHeight);
    std::fill_n(set.contributions[0].plane(1), set.contributions[0].pixelCount(), 0.F);  // no green at all
    for (const Operation& operation : lampOperations()) {
      const SolvedSet edited = applyEdits(set, stackOf(operation, ""));
      for (const Image& light : edited.contributions)
        for (int c = 0; c < 3; ++c)
          for (size_t p = 0; p < light.pixelCount(); ++p)
            ASSERT_TRUE(std::isfinite(light.plane(c)[p]) && light.plane(c)[p] >= 0)
                << operationName(operation);
    }
  }
}

TEST(LampEdit, ADarkLightStaysDarkAndANewOneToo) {
  SolvedSet set = smallSet(2, kWidth, kHeight);
  for (int c = 0; c < 3; ++c)
    std::fill_n(set.contributions[0].plane(c), set.contributions[0].pixelCount(), 0.F);
  EditStack stack = stackOf(MoveOperation{.1F, 0, 1}, "");
  stack.newLights = {"sun"};
  const SolvedSet edited = applyEdits(set, stack);
  for (const size_t dark : {0U, 2U})
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < edited.contributions[dark].pixelCount(); ++p)
        ASSERT_LT(edited.contributions[dark].plane(c)[p], 1e-5F);
}

TEST(LampEdit, SaysWhatNobodyCanKnow) {
  const SolvedSet spot = test::lampSet(kWidth, kHeight, {0, 0, .8, .2});
  const auto warned = [&](const Operation& operation, Mask mask = {}) {
    return applyEdits(spot, stackOf(operation, "key", std::move(mask))).capture.warnings;
  };
  using testing::ElementsAre;
  using testing::HasSubstr;
  EXPECT_THAT(warned(MoveOperation{}), ElementsAre());
  EXPECT_THAT(warned(MoveOperation{.01F, 0, 1}), ElementsAre());
  EXPECT_THAT(warned(MoveOperation{.2F, 0, 1}),
              ElementsAre(HasSubstr("\"key\" is a guess on"), HasSubstr("its shadows stay")));
  EXPECT_THAT(warned(TurnOperation{20, 0}), ElementsAre(HasSubstr("is a guess")));
  EXPECT_THAT(warned(SpreadOperation{2}), ElementsAre(HasSubstr("is a guess")));
  const SolvedSet aside = test::lampSet(kWidth, kHeight, {.6, 0, .8, .3});
  EXPECT_THAT(applyEdits(aside, stackOf(MoveOperation{.005F, 0, 1}, "key")).capture.warnings,
              ElementsAre(HasSubstr("is in the picture")));
  // Where the edit does not act nothing is guessed.
  EXPECT_THAT(warned(SpreadOperation{2}, Mask{{RectangleShape{0, 0, 10, 10, 0}, false}}), ElementsAre());
}

TEST(LampEdit, JudgesMovesTogether) {
  using testing::ElementsAre;
  using testing::HasSubstr;
  const SolvedSet bare = test::lampSet(kWidth, kHeight, {});  // no cone: nothing is a guess
  const auto warned = [&](const std::vector<std::pair<Operation, Mask>>& edits) {
    EditStack stack;
    for (const auto& [operation, mask] : edits) stack.append(*stackOf(operation, "key", mask).edits[0]);
    return applyEdits(bare, stack).capture.warnings;
  };
  const MoveOperation some{.15F, 0, 1};
  const MoveOperation back{-.1F, 0, 1};
  const Mask left{{RectangleShape{0, 0, 100, 270, 0}, false}};
  const Mask right{{RectangleShape{150, 0, 100, 270, 0}, false}};
  EXPECT_THAT(warned({{some, {}}}), ElementsAre());
  EXPECT_THAT(warned({{some, {}}, {some, {}}}), ElementsAre(HasSubstr("with the moves before")));
  EXPECT_THAT(warned({{some, {}}, {TurnOperation{5, 0}, {}}, {some, left}}),
              ElementsAre(HasSubstr("with the moves before")));
  EXPECT_THAT(warned({{some, left}, {some, right}}), ElementsAre()) << "nowhere together";
  EXPECT_THAT(warned({{some, {}}, {back, {}}, {some, {}}}), ElementsAre()) << "back, and there again";
  EditStack other = stackOf(some, "fill");
  other.append(*stackOf(some, "key").edits[0]);
  EXPECT_THAT(applyEdits(bare, other).capture.warnings, ElementsAre()) << "another light's";
  EditStack off = stackOf(some, "key");
  Edit first = *off.edits[0];
  first.on = false;
  off.replace(0, first);
  off.append(*stackOf(some, "key").edits[0]);
  EXPECT_THAT(applyEdits(bare, off).capture.warnings, ElementsAre()) << "one that is off";
}

TEST(LampEdit, SaysThatATurnCarriesTheLightOutOfThePicture) {
  using testing::Contains;
  using testing::ElementsAre;
  using testing::HasSubstr;
  using testing::Not;
  const auto outside = HasSubstr("middle of its light lies outside the picture");
  const SolvedSet bare = test::lampSet(kWidth, kHeight, {0, 0, .8});
  const auto warned = [](const SolvedSet& set, const std::vector<Operation>& operations) {
    EditStack stack;
    for (const Operation& operation : operations) stack.append(*stackOf(operation, "key").edits[0]);
    return applyEdits(set, stack).capture.warnings;
  };
  EXPECT_THAT(warned(bare, {TurnOperation{20, 0}}), ElementsAre());
  for (const TurnOperation& turn : {TurnOperation{50, 0}, TurnOperation{0, -50}, TurnOperation{-90, 90}})
    EXPECT_THAT(warned(bare, {turn}), ElementsAre(outside)) << turn.summary();
  EXPECT_THAT(warned(bare, {TurnOperation{25, 0}, TurnOperation{25, 0}}), ElementsAre(outside)) << "together";
  const SolvedSet spot = test::lampSet(kWidth, kHeight, {0, 0, .8, .2});
  EXPECT_THAT(warned(spot, {TurnOperation{20, 0}}), Not(Contains(outside)));
  EXPECT_THAT(warned(spot, {TurnOperation{70, 0}}), Contains(outside));
}

TEST(LampEdit, ChangesOnlyWhereItsMaskIs) {
  const SolvedSet set = smallSet(2, kWidth, kHeight);
  for (const Operation& operation : lampOperations()) {
    const Mask mask{{RectangleShape{100, 80, 60, 50, 0}, false}};
    const SolvedSet edited = applyEdits(set, stackOf(operation, "light1", mask));
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        if (x >= 99 && x <= 161 && y >= 79 && y <= 131) continue;
        ASSERT_EQ(edited.contributions[0].view().at(1, x, y), set.contributions[0].view().at(1, x, y));
      }
  }
}

TEST(LampEdit, GoesWithTheExposureOfTheSet) {
  for (const Operation& operation : {Operation(MoveOperation{.1F, -.05F, .8F}),
                                     Operation(TurnOperation{20, -10}), Operation(SpreadOperation{.5F})}) {
    const EditStack stack = stackOf(operation, "light1");
    const SolvedSet brighter = applyEdits(scaled(smallSet(2, kWidth, kHeight), 4), stack);
    const SolvedSet expected = scaled(applyEdits(smallSet(2, kWidth, kHeight), stack), 4);
    EXPECT_LT(largestDifference(brighter.contributions[0], expected.contributions[0]), 2e-3F)
        << operationName(operation);
  }
}

TEST(LampEdit, DoesNotMindTheOrderOfTheOtherLights) {
  const SolvedSet set = smallSet(3, kWidth, kHeight);
  SolvedSet other = smallSet(3, kWidth, kHeight);
  std::swap(other.contributions[1], other.contributions[2]);
  std::swap(other.capture.lights[1], other.capture.lights[2]);
  for (const Operation& operation : lampOperations()) {
    const EditStack stack = stackOf(operation, "light1");
    const SolvedSet a = applyEdits(set, stack);
    const SolvedSet b = applyEdits(other, stack);
    EXPECT_LT(largestDifference(a.contributions[0], b.contributions[0]), 1e-4F) << operationName(operation);
  }
}

TEST(LampEdit, TilesGiveWhatTheWholePictureGives) {
  const auto set = std::make_shared<const SolvedSet>(smallSet(3, kWidth, kHeight));
  EditedSet edited(set);
  EditStack stack;
  for (const Operation& operation : lampOperations()) {
    stack.append(*stackOf(operation, "light" + std::to_string(stack.edits.size() % 3 + 1)).edits[0]);
    edited.setStack(stack);
    edited.update();
    const SolvedSet reference = applyEdits(*set, stack);
    for (size_t i = 0; i < 3; ++i)
      ASSERT_LT(largestDifference(edited.result().contributions[i], reference.contributions[i]), 1e-6F);
  }
  edited.setStack({});
  edited.update();
  expectSameBits(edited.result(), *set);
}

// Against a truth: a wall with a texture, lit by a lamp that stands in front of it, and by another.
TEST(LampEdit, ALampInFrontOfAWallMovesAsARealOneWould) {
  const test::LampPlace before{-.1, .1, .7};
  for (const auto& [right, up, distance] : {std::array{.1F, 0.F, 1.F}, std::array{0.F, -.15F, 1.F}}) {
    const SolvedSet set = test::lampSet(kWidth, kHeight, before);
    const SolvedSet truth =
        test::lampSet(kWidth, kHeight, {before.x + right, before.y + up, before.z * distance});
    const SolvedSet edited = applyEdits(set, stackOf(MoveOperation{right, up, distance}, "key"));
    const double nothing = test::meanError(set.contributions[0], truth.contributions[0]);
    EXPECT_LT(test::meanError(edited.contributions[0], truth.contributions[0]), .4 * nothing)
        << right << ' ' << up;
  }
}

TEST(LampEdit, ASpotTurnsOntoWhatItNeverLit) {
  const test::LampPlace spot{0, 0, .8, .25};
  const SolvedSet set = test::lampSet(kWidth, kHeight, spot);
  test::LampPlace turned = spot;
  turned.panDegrees = 10;
  const SolvedSet truth = test::lampSet(kWidth, kHeight, turned);
  const SolvedSet edited = applyEdits(set, stackOf(TurnOperation{10, 0}, "key"));
  const double nothing = test::meanError(set.contributions[0], truth.contributions[0]);
  EXPECT_LT(test::meanError(edited.contributions[0], truth.contributions[0]), .3 * nothing);
}

TEST(LampEdit, ASpotsConeNarrowsAndWidens) {
  const test::LampPlace spot{0, 0, .8, .25};
  const SolvedSet set = test::lampSet(kWidth, kHeight, spot);
  // What a wider cone comes to was never lit: that is a guess.
  for (const auto& [width, left] : {std::array{.7F, .3F}, std::array{1.4F, .4F}}) {
    test::LampPlace other = spot;
    other.tangent *= width;
    const SolvedSet truth = test::lampSet(kWidth, kHeight, other);
    const SolvedSet edited = applyEdits(set, stackOf(SpreadOperation{width}, "key"));
    EXPECT_LT(test::meanError(edited.contributions[0], truth.contributions[0]),
              left * test::meanError(set.contributions[0], truth.contributions[0]))
        << width;
  }
}

}  // namespace
}  // namespace swaplight
