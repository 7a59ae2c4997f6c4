#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/edit/apply/edited_set.h"
#include "tests/support/small_set.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::smallSet;
using testing::HasSubstr;

constexpr int kWidth = 300;  // more than a tile
constexpr int kHeight = 270;

Edit makeEdit(const std::string& light, Operation operation, EnergyMode energy, Mask mask = {}) {
  Edit edit;
  edit.name = "test";
  if (!light.empty()) edit.lights = {light};
  edit.energy = energy;
  edit.operation = std::move(operation);
  edit.mask = std::move(mask);
  return edit;
}

Mask softEllipse() {
  return {{EllipseShape{140, 130, 90, 70, 30}, false}};
}

Mask painted(float x, float y, float radius = 30) {
  Painting painting(kWidth, kHeight);
  Stroke stroke;
  stroke.radius = radius;
  stroke.points = {{x, y, 1}, {x + 40, y + 10, 1}};
  painting.begin(stroke);
  return {{PaintShape{std::make_shared<const Painting>(painting)}, false}};
}

// One of every kind that needs no file and no shadows.
std::vector<Operation> operations() {
  return {FillOperation{.8f},    FillOperation{0},
          GainOperation{.5f, 0}, GainOperation{2, .1f},
          InvertOperation{},     CurveOperation{{{0, 0}, {.4f, .1f}, {.7f, .9f}, {1, 1}}},
          BlurOperation{9},      SharpenOperation{7, 1.5f}};
}

void expectSameBits(const SolvedSet& a, const SolvedSet& b) {
  ASSERT_EQ(a.lightCount(), b.lightCount());
  for (int i = 0; i < a.lightCount(); ++i)
    for (int c = 0; c < 3; ++c) {
      const auto& x = a.contributions[static_cast<size_t>(i)];
      const auto& y = b.contributions[static_cast<size_t>(i)];
      ASSERT_TRUE(std::equal(x.plane(c), x.plane(c) + x.pixelCount(), y.plane(c))) << "light " << i;
    }
}

float largestDifference(const Image& a, const Image& b) {
  float largest = 0;
  for (int c = 0; c < a.channelCount(); ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p)
      largest = std::max(largest, std::abs(a.plane(c)[p] - b.plane(c)[p]));
  return largest;
}

float largestDifference(const SolvedSet& a, const SolvedSet& b) {
  float largest = 0;
  for (size_t i = 0; i < a.contributions.size(); ++i)
    largest = std::max(largest, largestDifference(a.contributions[i], b.contributions[i]));
  return largest;
}

TEST(EditStack, EmptyIsTheIdentityToTheBit) {
  const auto set = std::make_shared<const SolvedSet>(smallSet(3, kWidth, kHeight));
  expectSameBits(applyEdits(*set, {}), *set);
  EditedSet edited(set);
  edited.update();
  expectSameBits(edited.result(), *set);
}

TEST(EditStack, EditsThatAreOffOrTransparentChangeNothing) {
  const SolvedSet set = smallSet(2, kWidth, kHeight);
  Edit off = makeEdit("light1", FillOperation{0}, EnergyMode::Add);
  off.on = false;
  Edit clear = makeEdit("light1", FillOperation{0}, EnergyMode::Redistribute);
  clear.opacity = 0;
  EditStack stack;
  stack.append(off);
  stack.append(clear);
  expectSameBits(applyEdits(set, stack), set);
}

TEST(EditStack, SharingKeepsTheSumOfBetaAndTheAllWhitePicture) {
  for (const int lights : {2, 3, 4}) {
    const SolvedSet set = smallSet(lights, kWidth, kHeight);
    const Image white = sumAtUnitWhite(set);
    EditStack all;
    for (const Operation& operation : operations())
      for (const char* light : {"light2", ""}) {
        EditStack stack;
        stack.append(makeEdit(light, operation, EnergyMode::Redistribute, softEllipse()));
        all.append(makeEdit(light, operation, EnergyMode::Redistribute, softEllipse()));
        const SolvedSet edited = applyEdits(set, stack);
        ASSERT_LT(largestDifference(sumAtUnitWhite(edited), white), 3e-6f)
            << operationName(operation) << light << lights;
        for (size_t p = 0; p < edited.beta.pixelCount(); ++p) {
          float sum = 0;
          float before = 0;
          for (int i = 0; i < lights; ++i) {
            ASSERT_GE(edited.beta.plane(i)[p], 0) << operationName(operation);
            sum += edited.beta.plane(i)[p];
            before += set.beta.plane(i)[p];
          }
          ASSERT_NEAR(sum, before, 1e-5);
        }
      }
    EXPECT_LT(largestDifference(sumAtUnitWhite(applyEdits(set, all)), white), 3e-5f);
  }
}

TEST(EditStack, SharingGivesALightWhatItAsksFor) {
  const SolvedSet set = smallSet(3, kWidth, kHeight);
  EditStack stack;
  stack.append(makeEdit("light2", FillOperation{.7f}, EnergyMode::Redistribute));
  const SolvedSet edited = applyEdits(set, stack);
  for (size_t p = 0; p < set.beta.pixelCount(); ++p) {
    if (set.beta.plane(1)[p] + set.beta.plane(0)[p] == 0) continue;
    ASSERT_NEAR(edited.beta.plane(1)[p], .7f, 1e-5);
    // The others keep their proportion to each other.
    ASSERT_NEAR(edited.beta.plane(0)[p] * set.beta.plane(2)[p],
                edited.beta.plane(2)[p] * set.beta.plane(0)[p], 1e-5);
  }
}

TEST(EditStack, AddingLeavesTheOtherLightsAloneToTheBit) {
  const SolvedSet set = smallSet(3, kWidth, kHeight);
  for (const Operation& operation : operations()) {
    EditStack stack;
    stack.append(makeEdit("light2", operation, EnergyMode::Add, softEllipse()));
    const SolvedSet edited = applyEdits(set, stack);
    EXPECT_EQ(largestDifference(edited.contributions[0], set.contributions[0]), 0);
    EXPECT_EQ(largestDifference(edited.contributions[2], set.contributions[2]), 0);
    EXPECT_GT(largestDifference(edited.contributions[1], set.contributions[1]), .005f)
        << operationName(operation);
  }
}

TEST(EditStack, AddedEditsOnDifferentLightsCommute) {
  const SolvedSet set = smallSet(3, kWidth, kHeight);
  for (const Operation& a : operations())
    for (const Operation& b : operations()) {
      EditStack one;
      one.append(makeEdit("light1", a, EnergyMode::Add, softEllipse()));
      one.append(makeEdit("light3", b, EnergyMode::Add, painted(150, 100)));
      EditStack other;
      other.edits = {one.edits[1], one.edits[0]};
      expectSameBits(applyEdits(set, one), applyEdits(set, other));
    }
}

TEST(EditStack, ChangesOnlyWhereItsMaskIs) {
  const SolvedSet set = smallSet(2, kWidth, kHeight);
  for (const EnergyMode energy : {EnergyMode::Redistribute, EnergyMode::Add})
    for (const Operation& operation : operations()) {
      EditStack stack;
      stack.append(makeEdit("light1", operation, energy, painted(100, 100)));
      const SolvedSet edited = applyEdits(set, stack);
      const auto& mask = std::get<PaintShape>(stack.edits[0]->mask[0].shape).painting->mask();
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
          if (mask.at(x, y) > 0) continue;
          for (size_t i = 0; i < 2; ++i)
            ASSERT_EQ(edited.contributions[i].view().at(1, x, y), set.contributions[i].view().at(1, x, y));
        }
    }
}

TEST(EditStack, InvertingTwoLightsLetsThemChangePlaces) {
  const SolvedSet set = smallSet(3, kWidth, kHeight);
  Edit edit = makeEdit("light1", InvertOperation{}, EnergyMode::Redistribute);
  edit.lights = {"light3", "light1"};
  EditStack stack;
  stack.append(edit);
  const SolvedSet edited = applyEdits(set, stack);
  EXPECT_LT(largestDifference(edited.contributions[0], set.contributions[2]), 1e-6f);
  EXPECT_LT(largestDifference(edited.contributions[2], set.contributions[0]), 1e-6f);
  EXPECT_EQ(largestDifference(edited.contributions[1], set.contributions[1]), 0);
}

TEST(EditStack, ANewLightIsPaintedInTheColoursOfTheSet) {
  const SolvedSet set = smallSet(2, kWidth, kHeight);
  EditStack stack;
  stack.newLights = {"sun"};
  stack.append(
      makeEdit("sun", FillOperation{.5f}, EnergyMode::Add, {{RectangleShape{50, 50, 100, 100}, false}}));
  const SolvedSet edited = applyEdits(set, stack);
  ASSERT_EQ(edited.lightCount(), 3);
  EXPECT_EQ(edited.capture.lights[2].name, "sun");
  const Image white = sumAtUnitWhite(set);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(edited.contributions[2].view().at(c, 100, 100), .5f * white.view().at(c, 100, 100), 1e-6);
    EXPECT_EQ(edited.contributions[2].view().at(c, 200, 100), 0);
  }
}

TEST(EditStack, SaysWhichLightIsUnknown) {
  const SolvedSet set = smallSet(2, 20, 20);
  EditStack stack;
  stack.append(makeEdit("moon", FillOperation{}, EnergyMode::Add));
  const std::string message = test::inputError([&] { (void)applyEdits(set, stack); });
  EXPECT_THAT(message, HasSubstr("moon"));
  EXPECT_THAT(message, HasSubstr("light1, light2"));
  stack.newLights = {"light2"};
  EXPECT_THAT(test::inputError([&] { (void)applyEdits(set, stack); }), HasSubstr("light2"));
}

/// The set takes the stack, and then is what applyEdits makes of it.
void followsTheReference(EditedSet& edited, const SolvedSet& set, const EditStack& stack, const char* what) {
  edited.setStack(stack);
  edited.update();
  const SolvedSet reference = applyEdits(set, stack);
  ASSERT_EQ(edited.result().lightCount(), reference.lightCount()) << what;
  ASSERT_EQ(edited.result().capture.lights.size(), reference.capture.lights.size()) << what;
  ASSERT_LT(largestDifference(edited.result(), reference), 2e-6f) << what;
}

TEST(EditedSet, EqualsTheReferenceAfterEveryChange) {
  const auto set = std::make_shared<const SolvedSet>(smallSet(3, kWidth, kHeight));
  EditedSet edited(set);
  EditStack stack;
  const auto check = [&](const char* what) { followsTheReference(edited, *set, stack, what); };
  int k = 0;
  for (const Operation& operation : operations()) {
    stack.append(makeEdit("light" + std::to_string(k % 3 + 1), operation,
                          k % 2 ? EnergyMode::Add : EnergyMode::Redistribute,
                          k % 3 == 0 ? softEllipse() : painted(60.f + 20.f * static_cast<float>(k), 240)));
    ++k;
    check("appended");
  }
  std::swap(stack.edits[1], stack.edits[6]);
  check("reordered");
  Edit off = *stack.edits[6];
  off.on = false;
  stack.replace(6, off);
  check("switched off");
  stack.edits.erase(stack.edits.begin() + 2);
  check("deleted");
  stack.newLights = {"sun"};
  stack.append(makeEdit("sun", FillOperation{.5f}, EnergyMode::Redistribute, painted(20, 20)));
  check("light added");
}

TEST(EditedSet, EqualsTheReferenceWhileLightsComeAndGo) {
  const auto set = std::make_shared<const SolvedSet>(smallSet(3, kWidth, kHeight));
  EditedSet edited(set);
  EditStack stack;
  const auto check = [&](const char* what) { followsTheReference(edited, *set, stack, what); };
  stack.append(makeEdit("", GainOperation{.5f, .1f}, EnergyMode::Add, painted(60, 240)));
  stack.append(makeEdit("light2", FillOperation{0}, EnergyMode::Redistribute, softEllipse()));
  check("without");
  stack.newLights = {"sun"};
  check("a light for which nothing was painted, and which an edit of all lights reaches");
  stack.append(makeEdit("sun", GainOperation{1, .5f}, EnergyMode::Add, painted(20, 20)));
  check("painted");
  stack.newLights = {"sun", "moon"};
  stack.append(makeEdit("moon", FillOperation{.4f}, EnergyMode::Redistribute, painted(90, 50)));
  check("a second one");
  stack.edits.erase(stack.edits.begin() + 2);
  stack.newLights = {"moon"};
  check("the first one gone");
  stack.edits.pop_back();
  stack.newLights = {};
  check("both gone");
}

TEST(EditedSet, MakesNothingAgainForALightThatIsDark) {
  const auto set = std::make_shared<const SolvedSet>(smallSet(2, 600, 600));
  EditedSet edited(set);
  edited.update();
  const float* pixels = edited.result().contributions[1].view().data;
  EditStack stack;
  stack.newLights = {"sun"};
  edited.setStack(stack);
  EXPECT_FALSE(edited.staleTile());
  EXPECT_EQ(edited.result().contributions[1].view().data, pixels);
  EXPECT_EQ(edited.result().contributions[2].view().at(0, 300, 300), 0);
}

TEST(EditedSet, ComputesOnlyWhatAStrokeCanHaveChanged) {
  const auto set = std::make_shared<const SolvedSet>(smallSet(2, 900, 900));
  Painting painting(900, 900);
  Stroke stroke;
  stroke.radius = 10;
  stroke.points = {{300, 300, 1}};
  painting.begin(stroke);
  const auto withPainting = [&] {
    return makeEdit("light1", FillOperation{1}, EnergyMode::Add,
                    {{PaintShape{std::make_shared<const Painting>(painting)}, false}});
  };
  EditStack stack;
  stack.append(withPainting());
  stack.append(makeEdit("light2", BlurOperation{5}, EnergyMode::Redistribute));
  EditedSet edited(set);
  edited.setStack(stack);
  edited.update();

  painting.add({340, 300, 1});
  stack.replace(0, withPainting());
  edited.setStack(stack);
  const std::vector<PixelRect> changed = edited.update();
  ASSERT_EQ(changed.size(), 1u);
  EXPECT_LE(changed[0].width, 40 + 2 * 10 + 2 * 5 + 2);
  EXPECT_LE(changed[0].height, 2 * 10 + 2 * 5 + 2);
  EXPECT_LT(largestDifference(edited.result(), applyEdits(*set, stack)), 2e-6f);
  EXPECT_TRUE(edited.update().empty());
}

TEST(EditedSet, EqualsTheReferenceWhileAStrokeGoesOnInTheMiddleOfTheStack) {
  const auto set = std::make_shared<const SolvedSet>(smallSet(3, kWidth, kHeight));
  for (const bool blurAbove : {false, true}) {
    EditStack stack;
    stack.append(makeEdit("light1", BlurOperation{6}, EnergyMode::Redistribute));
    stack.append(makeEdit("light2", GainOperation{.7f, .1f}, EnergyMode::Redistribute, softEllipse()));
    stack.append(makeEdit("light3", FillOperation{1}, EnergyMode::Redistribute));
    stack.append(makeEdit("light1", InvertOperation{}, EnergyMode::Add, softEllipse()));
    if (blurAbove) stack.append(makeEdit("light2", SharpenOperation{4, 1}, EnergyMode::Redistribute));
    EditedSet edited(set);
    Painting painting(kWidth, kHeight);
    painting.begin(Stroke{});
    for (int k = 0; k < 8; ++k) {
      painting.add({200 + 14 * static_cast<float>(k), 240 + 4 * static_cast<float>(k), 1});
      Edit edit = *stack.edits[2];
      edit.mask = {{PaintShape{std::make_shared<const Painting>(painting)}, false}};
      stack.replace(2, edit);
      edited.setStack(stack);
      edited.update();
      ASSERT_LT(largestDifference(edited.result(), applyEdits(*set, stack)), 2e-6f) << k;
    }
    // A change below the painted edit makes what was remembered untrue.
    stack.replace(0, makeEdit("light1", GainOperation{.2f, 0}, EnergyMode::Redistribute));
    edited.setStack(stack);
    edited.update();
    ASSERT_LT(largestDifference(edited.result(), applyEdits(*set, stack)), 2e-6f);
  }
}

TEST(EditedSet, IsLazy) {
  const auto set = std::make_shared<const SolvedSet>(smallSet(2, 600, 600));
  EditedSet edited(set);
  edited.update();
  EditStack stack;
  stack.append(makeEdit("light1", FillOperation{0}, EnergyMode::Add));
  edited.setStack(stack);
  EXPECT_EQ(edited.update({10, 10, 20, 20}).size(), 1u);
  EXPECT_EQ(edited.update({10, 10, 20, 20}).size(), 0u);
  EXPECT_EQ(edited.update().size(), 8u);
}

TEST(EditedSet, UndoRestoresToTheBit) {
  const auto set = std::make_shared<const SolvedSet>(smallSet(3, kWidth, kHeight));
  EditedSet edited(set);
  std::vector<EditStack> history = {{}};
  std::vector<SolvedSet> results;
  results.push_back(applyEdits(*set, {}));
  int k = 0;
  for (const Operation& operation : operations()) {
    EditStack next = history.back();
    next.append(makeEdit("light1", operation, k++ % 2 ? EnergyMode::Add : EnergyMode::Redistribute,
                         painted(100, 120)));
    edited.setStack(next);
    edited.update();
    history.push_back(next);
  }
  for (size_t i = history.size(); i-- > 0;) {
    edited.setStack(history[i]);
    edited.update();
    EditedSet fresh(set);
    fresh.setStack(history[i]);
    fresh.update();
    EXPECT_LT(largestDifference(edited.result(), fresh.result()), 1e-6f) << i;
  }
  expectSameBits(edited.result(), *set);
}

TEST(EditedSet, KeepsTheOldStackWhereTheNewOneIsBad) {
  const auto set = std::make_shared<const SolvedSet>(smallSet(2, kWidth, kHeight));
  EditedSet edited(set);
  EditStack good;
  good.append(makeEdit("light1", FillOperation{0}, EnergyMode::Add));
  edited.setStack(good);
  EditStack bad = good;
  bad.append(makeEdit("moon", FillOperation{0}, EnergyMode::Add));
  EXPECT_THROW(edited.setStack(bad), InputError);
  EXPECT_EQ(edited.stack(), good);
  edited.update();
  EXPECT_LT(largestDifference(edited.result(), applyEdits(*set, good)), 1e-6f);
}

}  // namespace
}  // namespace swaplight
