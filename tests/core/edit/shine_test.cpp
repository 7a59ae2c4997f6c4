#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "core/base/json.h"
#include "core/edit/apply/edited_set.h"
#include "tests/support/small_set.h"

namespace swaplight {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr int kWidth = 300, kHeight = 270;  // more than a tile

/// A third of one light and three fifths of the other are highlight in the middle of the picture, none
/// elsewhere.
SolvedSet glossySet() {
  SolvedSet set = test::smallSet(2, kWidth, kHeight);
  for (const Image& light : set.contributions) {
    const float part = set.highlights.empty() ? 1 / 3.0F : 0.6F;
    Image& highlight = set.highlights.emplace_back(light.clone());
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
          highlight.span().at(c, x, y) *= std::hypot(float(x) - 150, float(y) - 130) < 80 ? part : 0.0F;
  }
  return set;
}

Edit shine(float amount, const std::string& light = "", Mask mask = {}) {
  Edit edit;
  edit.name = "shine";
  if (!light.empty()) edit.lights = {light};
  edit.operation = ShineOperation{amount};
  edit.mask = std::move(mask);
  return edit;
}

/// Both lights change places, but not in a hole at the edge of a tile.
Edit swapped() {
  Edit edit;
  edit.operation = InvertOperation{};
  edit.mask = {{EllipseShape{256, 130, 40, 40, 20}, true}};
  return edit;
}

SolvedSet shone(const SolvedSet& set, const std::vector<Edit>& edits) {
  EditStack stack;
  for (const Edit& edit : edits) stack.append(edit);
  return applyEdits(set, stack);
}

/// Light and highlights are the same, to this difference.
void expectSame(const SolvedSet& one, const SolvedSet& other, float difference = 0) {
  for (size_t i = 0; i < other.contributions.size(); ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < other.beta.pixelCount(); ++p) {
        ASSERT_NEAR(one.contributions[i].plane(c)[p], other.contributions[i].plane(c)[p], difference) << p;
        ASSERT_NEAR(one.highlights[i].plane(c)[p], other.highlights[i].plane(c)[p], difference) << p;
      }
}

/// The largest difference of a light to its contribution and `times` its highlight.
float errorOf(const SolvedSet& edited, const SolvedSet& set, size_t light, float times) {
  float largest = 0;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < set.beta.pixelCount(); ++p)
      largest = std::max(largest, std::abs(edited.contributions[light].plane(c)[p] -
                                           (set.contributions[light].plane(c)[p] +
                                            times * set.highlights[light].plane(c)[p])));
  return largest;
}

TEST(Shine, AsPhotographedIsTheIdentityToTheBit) {
  const SolvedSet set = glossySet();
  const SolvedSet edited = shone(set, {shine(1)});
  for (size_t i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < set.beta.pixelCount(); ++p)
        ASSERT_EQ(edited.contributions[i].plane(c)[p], set.contributions[i].plane(c)[p]);
}

TEST(Shine, AddsTheHighlightAsOftenAsItIsTold) {
  const SolvedSet set = glossySet();
  for (const float amount : {0.0F, 0.5F, 2.0F, 3.0F}) {
    const SolvedSet edited = shone(set, {shine(amount, "light2")});
    EXPECT_LT(errorOf(edited, set, 1, amount - 1), 1e-6F) << amount;
    EXPECT_EQ(errorOf(edited, set, 0, 0), 0) << "the other light stays";
  }
}

TEST(Shine, ActsWithinItsMask) {
  const SolvedSet set = glossySet();
  const SolvedSet edited = shone(set, {shine(0, "", {{RectangleShape{0, 0, 150, kHeight, 0}, false}})});
  const auto change = [&](int x, int y) {
    return edited.contributions[0].view().at(1, x, y) - set.contributions[0].view().at(1, x, y);
  };
  EXPECT_LT(change(120, 130), -0.01F);
  EXPECT_EQ(change(170, 130), 0);
}

TEST(Shine, AppliedTwiceMultiplies) {
  const SolvedSet set = glossySet();
  EXPECT_LT(errorOf(shone(set, {shine(0), shine(0)}), set, 0, -1), 1e-6F);
  EXPECT_LT(errorOf(shone(set, {shine(0), shine(3)}), set, 0, -1), 1e-6F);
  EXPECT_LT(errorOf(shone(set, {shine(2), shine(0.5F)}), set, 0, 0), 1e-6F);
}

TEST(Shine, HasNothingToAddToALightThatIsGone) {
  const SolvedSet set = glossySet();
  Edit gone = shine(1, "light1");
  gone.operation = FillOperation{0};
  gone.energy = EnergyMode::Add;
  const SolvedSet edited = shone(set, {gone, shine(3, "light1")});
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < set.beta.pixelCount(); ++p) ASSERT_EQ(edited.contributions[0].plane(c)[p], 0);
}

TEST(Shine, KeepsTheHighlightsWithinTheirLights) {
  const SolvedSet set = glossySet();
  const SolvedSet edited = shone(set, {shine(3, "light1"), shine(0.25F, "light2")});
  ASSERT_EQ(edited.highlights.size(), 2U);
  const float times[2] = {3, 0.25F};
  for (size_t i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < set.beta.pixelCount(); ++p) {
        ASSERT_LE(edited.highlights[i].plane(c)[p], edited.contributions[i].plane(c)[p]);
        ASSERT_NEAR(edited.highlights[i].plane(c)[p], times[i] * set.highlights[i].plane(c)[p], 1e-6F);
      }
}

TEST(Shine, FollowsLightsThatChangePlaces) {
  const SolvedSet set = glossySet();
  for (const float amount : {0.0F, 2.0F})
    expectSame(shone(set, {swapped(), shine(amount)}), shone(set, {shine(amount), swapped()}), 1e-6F);
}

TEST(Shine, OfTilesIsThatOfThePicture) {
  const auto set = std::make_shared<const SolvedSet>(glossySet());
  EditStack stack;
  stack.newLights = {"sun"};
  stack.append(shine(2, "light1", {{EllipseShape{150, 130, 60, 50, 20}, false}}));
  stack.append(swapped());
  stack.append(shine(0.5F));
  const SolvedSet whole = applyEdits(*set, stack);
  EditedSet edited(set);
  edited.update();
  edited.setStack(stack);
  edited.update();
  expectSame(edited.result(), whole);
}

TEST(Shine, OfWhatIsPaintedAboveALightThatIsGoneIsThatOfThePicture) {
  const auto set = std::make_shared<const SolvedSet>(glossySet());
  EditedSet edited(set);
  EditStack stack;
  Edit fill;
  fill.lights = {"light1"};
  fill.operation = FillOperation{0};
  fill.energy = EnergyMode::Add;
  stack.append(fill);
  edited.setStack(stack);
  edited.update();
  Painting painting(kWidth, kHeight);
  Stroke stroke;
  stroke.radius = 30;
  stroke.points = {{100, 130, 1}, {200, 130, 1}};
  painting.begin(stroke);
  fill.operation = FillOperation{0.5F};
  fill.mask = {{PaintShape{std::make_shared<const Painting>(painting)}, false}};
  stack.append(fill);
  edited.setStack(stack);
  edited.update();
  expectSame(edited.result(), applyEdits(*set, stack));
}

TEST(Shine, ComesBackFromItsFile) {
  EditStack stack;
  stack.append(shine(2.5F, "light1"));
  const EditStack back = editStackFromJson(jsonFromEditStack(stack), kWidth, kHeight);
  EXPECT_EQ(back, stack);
  EXPECT_EQ(operationName(back.edits.front()->operation), "shine");
}

TEST(Shine, OfASetWithoutHighlightsChangesNothingAndSaysSo) {
  SolvedSet set = glossySet();
  set.highlights.clear();
  const SolvedSet edited = shone(set, {shine(3)});
  EXPECT_EQ(edited.contributions[0].plane(1)[5000], set.contributions[0].plane(1)[5000]);
  EXPECT_THAT(edited.capture.warnings, Contains(HasSubstr("has no highlights")));
  EXPECT_TRUE(edited.highlights.empty());
  EXPECT_TRUE(shone(glossySet(), {shine(3)}).capture.warnings.empty());
}

TEST(Shine, HighlightsThatNothingTouchesStayToTheBit) {
  SolvedSet set = glossySet();
  std::mt19937 random(3);
  std::uniform_real_distribution<float> part(0, 1);
  for (size_t i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < set.beta.pixelCount(); ++p)
        set.highlights[i].plane(c)[p] = part(random) * set.contributions[i].plane(c)[p];
  expectSame(shone(set, {}), set);
  const std::string first = set.capture.lights[0].name;
  expectSame(shone(set, {shine(1)}), set);
  const SolvedSet edited = shone(set, {shine(2, first)});  // the other light is as it was
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < set.beta.pixelCount(); ++p)
      ASSERT_EQ(edited.highlights[1].plane(c)[p], set.highlights[1].plane(c)[p]);
}

}  // namespace
}  // namespace swaplight
