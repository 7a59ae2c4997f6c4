#include "core/edit/operations/recolor_operation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/json.h"
#include "core/edit/apply/edited_set.h"
#include "core/edit/mask/surface_color.h"
#include "tests/support/small_set.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::smallSet;
using testing::HasSubstr;
using Kind = RecolorOperation::Kind;

constexpr int kWidth = 300;  // more than a tile
constexpr int kHeight = 270;
constexpr Rgb kRed{.7F, .12F, .05F}, kBlue{.08F, .2F, .6F};

Edit recolor(const RecolorOperation& operation, Mask mask = {}) {
  Edit edit;
  edit.name = "test";
  edit.operation = operation;
  edit.mask = std::move(mask);
  return edit;
}

RecolorOperation shift(float hue, float saturation, float lightness) {
  return {Kind::Shift, hue, saturation, lightness, Rgb(1), Rgb(1)};
}

RecolorOperation fromTo(const Rgb& from, const Rgb& to) {
  return {Kind::Color, 0, 1, 1, from, to};
}

/// A surface of one reflectance under lights of different strength, with a white highlight of light 1 in a
/// corner.
SolvedSet painted(const Rgb& reflectance) {
  SolvedSet set = smallSet(2, kWidth, kHeight);
  for (int i = 0; i < 2; ++i)
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        for (int c = 0; c < 3; ++c) {
          const float shade = .1F + .8F * float(i == 0 ? x : kWidth - x) / kWidth;
          const float gloss = i == 1 && x < 50 && y < 50 ? .3F : 0;
          set.contributions[size_t(i)].span().at(c, x, y) = shade * reflectance[c] + gloss;
        }
  set.ambient = Image(ImageSpec::rgb(kWidth, kHeight));
  for (int c = 0; c < 3; ++c)
    std::fill_n(set.ambient->plane(c), set.ambient->pixelCount(), .05F * reflectance[c]);
  updateBeta(set);
  return set;
}

float largestDifference(const Image& a, const Image& b) {
  float largest = 0;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p)
      largest = std::max(largest, std::abs(a.plane(c)[p] - b.plane(c)[p]));
  return largest;
}

TEST(Recolor, IsTheSetAsIfTheSurfaceHadBeenPainted) {
  const SolvedSet red = painted(kRed), blue = painted(kBlue);
  EditStack stack;
  stack.append(recolor(fromTo(kRed, kBlue)));
  const SolvedSet edited = applyEdits(red, stack);
  for (size_t i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < kHeight; ++y)
        for (int x = 50; x < kWidth; ++x)
          ASSERT_NEAR(edited.contributions[i].view().at(c, x, y), blue.contributions[i].view().at(c, x, y),
                      1e-5);
  for (int c = 0; c < 3; ++c)
    for (int x = 50; x < kWidth; ++x)
      ASSERT_NEAR(edited.ambient->view().at(c, x, 20), blue.ambient->view().at(c, x, 20), 1e-5)
          << "ambient light falls on it, too";
  // The highlight is no part of the colour: the sum at unit white is exact, and the light that makes it is
  // told from the other one by shares, which differ between the channels there.
  for (int c = 0; c < 3; ++c) {
    const auto sum = [&](const SolvedSet& set) {
      return set.contributions[0].view().at(c, 20, 20) + set.contributions[1].view().at(c, 20, 20);
    };
    EXPECT_NEAR(sum(edited), sum(blue), 2e-3);
  }
}

TEST(Recolor, ThereAndBackIsWhereItBegan) {
  const SolvedSet red = painted(kRed);
  EditStack stack;
  stack.append(recolor(fromTo(kRed, kBlue)));
  stack.append(recolor(fromTo(kBlue, kRed)));
  const SolvedSet edited = applyEdits(red, stack);
  for (int x = 50; x < kWidth; ++x)
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(edited.contributions[0].view().at(c, x, 100), red.contributions[0].view().at(c, x, 100),
                  1e-4);
}

TEST(Recolor, NothingToDoChangesNothingToTheBit) {
  const SolvedSet set = smallSet(3, kWidth, kHeight);
  for (const RecolorOperation& operation : {RecolorOperation{}, fromTo(kRed, kRed)}) {
    EditStack stack;
    stack.append(recolor(operation));
    const SolvedSet edited = applyEdits(set, stack);
    for (size_t i = 0; i < 3; ++i)
      EXPECT_EQ(largestDifference(edited.contributions[i], set.contributions[i]), 0);
  }
}

/// The shadows of light 0: its left half is hidden, where it would give as much as anywhere.
ShadowSource halfHidden(const Rgb& reflectance) {
  auto shadows = std::make_shared<LightShadows>();
  shadows->visibility = Image(ImageSpec{kWidth, kHeight, {"Y"}, "data"});
  shadows->direct = Image(ImageSpec::rgb(kWidth, kHeight));
  shadows->labels.resize(shadows->visibility.pixelCount());
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      shadows->visibility.span().at(0, x, y) = x < kWidth / 2 ? 0.F : 1.F;
      shadows->labels[size_t(y * kWidth + x)] = x < kWidth / 2 ? ShadowLabel::Umbra : ShadowLabel::Lit;
      for (int c = 0; c < 3; ++c) shadows->direct.span().at(c, x, y) = .5F * reflectance[c];
    }
  return [shadows](const std::string&) { return shadows; };
}

Edit filledShadow() {
  Edit edit = recolor({});
  edit.lights = {"key"};
  edit.energy = EnergyMode::Add;
  ShadowOperation lighten;
  lighten.kind = ShadowOperation::Kind::Lighten;
  edit.operation = lighten;
  return edit;
}

TEST(Recolor, LightThatALaterEditAddsFallsOnTheNewColour) {
  SolvedSet set = painted(kRed);
  set.capture.lights[0].name = "key";
  EditStack stack;
  stack.append(recolor(fromTo(kRed, kBlue)));
  const SolvedSet recolored = applyEdits(set, stack);
  stack.append(filledShadow());
  const SolvedSet filled = applyEdits(set, stack, halfHidden(kRed));
  const auto added = [&](int c) {
    return filled.contributions[0].view().at(c, 100, 100) - recolored.contributions[0].view().at(c, 100, 100);
  };
  EXPECT_GT(added(2), .1F);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(added(c) / added(2), kBlue[c] / kBlue.b, .01) << c;
}

/// Where the whole set is dark its colour is noise, and a recolouring does not make it light.
TEST(Recolor, OfADarkPlaceThatWasFilledMakesNoSpeckles) {
  SolvedSet set = painted(kRed);
  set.capture.lights[0].name = "key";
  set.report.emplace();
  set.report->noise.read = 1e-3;
  std::mt19937 random(5);
  std::uniform_real_distribution<float> noise(0, 2e-3F);
  for (Image& light : set.contributions)
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < kHeight; ++y)
        for (int x = 60; x < 140; ++x) light.span().at(c, x, y) = noise(random);
  EditStack stack;
  stack.append(filledShadow());
  stack.append(recolor(shift(120, 1, 1)));
  const SolvedSet edited = applyEdits(set, stack, halfHidden(kRed));
  float brightest = 0;
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < kHeight; ++y)
      for (int x = 60; x < 140; ++x)
        brightest = std::max(brightest, edited.contributions[0].view().at(c, x, y));
  EXPECT_LT(brightest, 2.5F * .5F * kRed.r);  // all of the light in one channel
}

TEST(Recolor, KeepsGreyGreyAndLightLinear) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int k = 0; k < 2000; ++k) {
    const RecolorOperation turned = shift(360 * unit(random) - 180, 2 * unit(random), 3 * unit(random));
    const RecolorOperation set =
        fromTo({unit(random), unit(random), unit(random)}, {unit(random), unit(random), unit(random)});
    const Rgb grey = turned.recolored(Rgb(.4F));
    ASSERT_NEAR(grey.r, grey.g, 1e-4);
    ASSERT_NEAR(grey.r, grey.b, 1e-4);
    const Rgb light(unit(random), unit(random) < .2F ? 0 : unit(random), unit(random));
    for (const RecolorOperation& operation : {turned, set}) {
      const Rgb once = operation.recolored(light), twice = operation.recolored(4.0F * light);
      for (int c = 0; c < 3; ++c) {
        ASSERT_GE(once[c], 0);
        ASSERT_TRUE(std::isfinite(once[c]));
        ASSERT_NEAR(twice[c], 4 * once[c], 1e-4 * (1 + twice[c]));
      }
    }
  }
  EXPECT_EQ(shift(90, 2, 1).recolored(Rgb(0)), Rgb(0));
}

TEST(Recolor, AHueThatIsTurnedRoundIsTheSame) {
  const Rgb light(.3F, .5F, .2F);
  Rgb turned = light;
  for (int k = 0; k < 4; ++k) turned = shift(90, 1, 1).recolored(turned);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(turned[c], light[c], 1e-3);
  const Rgb red = shift(-120, 1, 1).recolored({.1F, .5F, .1F});
  EXPECT_GT(red.r, red.g) << "green turned back is red";
  const Rgb grey = shift(0, 0, 1).recolored(light);
  EXPECT_NEAR(grey.r, grey.b, 1e-4);
}

TEST(Recolor, StaysFiniteWhereASurfaceReflectsNothingOfAChannel) {
  SolvedSet set = smallSet(2, 40, 30);
  for (Image& light : set.contributions)
    for (size_t p = 0; p < light.pixelCount(); ++p) light.plane(2)[p] = p % 3 ? 0 : 1e-30F;
  EditStack stack;
  stack.append(recolor(fromTo({.5F, .5F, 0}, {.1F, .1F, 4})));
  const SolvedSet edited = applyEdits(set, stack);
  for (const Image& light : edited.contributions)
    for (size_t p = 0; p < light.pixelCount(); ++p) {
      ASSERT_TRUE(std::isfinite(light.plane(2)[p]));
      ASSERT_LT(light.plane(2)[p], 20);
    }
}

TEST(Recolor, WhatIsLitLaterIsOfTheNewColour) {
  const auto set = std::make_shared<const SolvedSet>(painted(kRed));
  EditStack stack;
  stack.append(recolor(fromTo(kRed, kBlue), {{EllipseShape{140, 130, 90, 70, 10}, false}}));
  stack.newLights = {"sun"};
  const auto paintedEdit = [](float x) {
    Painting painting(kWidth, kHeight);
    Stroke stroke;
    stroke.radius = 20;
    stroke.points = {{100, 130, 1}, {x, 130, 1}};
    painting.begin(stroke);
    Edit edit;
    edit.lights = {"sun"};
    edit.energy = EnergyMode::Add;
    edit.operation = FillOperation{1};
    edit.mask = {{PaintShape{std::make_shared<const Painting>(painting)}, false}};
    return edit;
  };
  EditedSet edited(set);
  edited.setStack(stack);
  edited.update();
  for (const float x : {110.F, 140.F, 170.F}) {  // as a stroke goes on
    if (x > 110) stack.edits.pop_back();
    stack.append(paintedEdit(x));
    edited.setStack(stack);
    edited.update();
    const SolvedSet reference = applyEdits(*set, stack);
    for (size_t i = 0; i < 3; ++i)
      ASSERT_LT(largestDifference(edited.result().contributions[i], reference.contributions[i]), 2e-6F);
    ASSERT_LT(largestDifference(*edited.result().ambient, *reference.ambient), 1e-6F);
  }
  const Image& sun = edited.result().contributions[2];
  EXPECT_NEAR(sun.view().at(2, 120, 130) / sun.view().at(0, 120, 130), kBlue.b / kBlue.r, 1e-3);
}

TEST(Recolor, IsReadAsItWasWritten) {
  EditStack stack;
  stack.width = 200, stack.height = 100;
  for (const RecolorOperation& operation : {shift(-30, .5F, 2), fromTo(kRed, kBlue)})
    stack.append(recolor(operation));
  Edit gel;
  gel.operation = UnknownGelOperation{.25F, UnknownGelOperation::Lamps::Exchanged};
  stack.append(gel);
  EXPECT_EQ(editStackFromJson(Json::parse(jsonFromEditStack(stack).dump()), 200, 100), stack);
}

TEST(Recolor, IsUnderAllLights) {
  const SolvedSet set = smallSet(2, 20, 20);
  Edit edit = recolor(shift(90, 1, 1));
  edit.lights = {"light1"};
  EditStack stack;
  stack.append(edit);
  EXPECT_THAT(test::inputError([&] { (void)applyEdits(set, stack); }),
              HasSubstr("acts on all of them: leave out its lights"));
}

TEST(Recolor, TheColourOfAMaskIsItsMean) {
  const SolvedSet set = painted(kRed);
  MaskContext context(set);
  const Rgb mean = surfaceColor(set, PreparedMask({{RectangleShape{100, 100, 80, 80, 0}, false}}, context));
  EXPECT_NEAR(mean.g / mean.r, kRed.g / kRed.r, 1e-4);
  EXPECT_EQ(surfaceColor(set, PreparedMask({{RectangleShape{900, 100, 80, 80, 0}, false}}, context)), Rgb(1));
}

}  // namespace
}  // namespace swaplight
