#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/edit/apply/edited_set.h"
#include "core/edit/pool/penumbra_scales.h"
#include "tests/support/lamp_set.h"

namespace swaplight {
namespace {

constexpr int kWidth = 400;  // more than a tile
constexpr int kHeight = 300;

/// A shadow left of an upright line, with an edge this wide: pixels.
float ramp(double x, double width) {
  return static_cast<float>(std::clamp((x - .5 * kWidth) / width + .5, 0., 1.));
}

Image shadowEdge(double width) {
  Image visibility(ImageSpec{kWidth, kHeight, {"Y"}, "data"});
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) visibility.span().at(0, x, y) = ramp(x + .5, width);
  return visibility;
}

/// Of an edge across a row.
double widthOf(const std::vector<float>& visibility) {
  double area = 0;
  for (const float v : visibility) area += 6. * v * (1 - v);
  return area;
}

std::vector<float> seenWith(const PenumbraScales& scales, float times, float diameter) {
  std::vector<float> row(kWidth);
  scales.row(times, diameter, 0, kHeight / 2, kWidth, row.data());
  return row;
}

EditStack sized(const SizeOperation& size, Mask mask = {}) {
  Edit edit;
  edit.lights = {"key"};
  edit.energy = EnergyMode::Add;
  edit.operation = size;
  edit.mask = std::move(mask);
  EditStack stack;
  stack.append(edit);
  return stack;
}

std::vector<ShadowLabel> labelsOf(const Image& visibility) {
  std::vector<ShadowLabel> labels(visibility.pixelCount());
  std::transform(visibility.plane(0), visibility.plane(0) + labels.size(), labels.begin(), [](float v) {
    return v > .95F ? ShadowLabel::Lit : v < .05F ? ShadowLabel::Umbra : ShadowLabel::Penumbra;
  });
  return labels;
}

/// The key's light on a wall, a part of it hidden left of a line; and what it would be without.
struct ShadowedWall {
  SolvedSet set;
  std::shared_ptr<LightShadows> shadows = std::make_shared<LightShadows>();

  explicit ShadowedWall(double width, const test::LampPlace& lamp = {})
      : set(test::lampSet(kWidth, kHeight, lamp)) {
    shadows->visibility = shadowEdge(width);
    for (int y = 0; y < kHeight; ++y)  // light all around: or it would be a spot's
      std::fill_n(shadows->visibility.span().row(0, y), y < kHeight / 3 ? kWidth : kWidth / 4, 1.F);
    shadows->labels = labelsOf(shadows->visibility);
    shadows->direct = set.contributions[0].clone();
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < shadows->direct.pixelCount(); ++p)
        set.contributions[0].plane(c)[p] *= shadows->visibility.plane(0)[p];
    updateBeta(set);
  }
  [[nodiscard]] ShadowSource source() const {
    return [all = shadows](const std::string& /*light*/) { return all; };
  }
};

/// A softbox before a wall: many small lamps.
SolvedSet softboxSet(const test::LampPlace& middle, double diameter) {
  SolvedSet sum = test::lampSet(kWidth, kHeight, middle);
  for (int c = 0; c < 3; ++c)
    std::fill_n(sum.contributions[0].plane(c), sum.contributions[0].pixelCount(), 0.F);
  constexpr int kSide = 9;
  int count = 0;
  for (const bool adds : {false, true})
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i) {
        const double dx = (2. * i + 1) / kSide - 1;
        const double dy = (2. * j + 1) / kSide - 1;
        if (dx * dx + dy * dy > 1) continue;
        if (!adds) {
          ++count;
          continue;
        }
        const SolvedSet one = test::lampSet(
            kWidth, kHeight, {middle.x + .5 * diameter * dx, middle.y + .5 * diameter * dy, middle.z});
        for (int c = 0; c < 3; ++c)
          for (size_t p = 0; p < one.contributions[0].pixelCount(); ++p)
            sum.contributions[0].plane(c)[p] += one.contributions[0].plane(c)[p] / static_cast<float>(count);
      }
  return sum;
}

TEST(PenumbraScales, AnEdgeGetsAsManyTimesAsWideAsTheLamp) {
  for (const double width : {8., 20.}) {
    const Image visibility = shadowEdge(width);
    const PenumbraScales scales(visibility, std::nullopt);
    for (const float times : {.25F, .5F, 1.F, 2.F, 4.F})
      EXPECT_NEAR(widthOf(seenWith(scales, times, 1)), times * width, .15 * times * width + .5)
          << width << " px, x " << times;
  }
}

/// What a function finds where it has not written is no number.
[[gnu::noinline]] void leaveNothingOnTheStack() {
  volatile float left[8192];
  for (volatile float& value : left) value = std::nanf("");
}

/// All of a row blurred as far as it can be.
TEST(PenumbraScales, TheWidestBlurNeedsNoOtherOnes) {
  const Image visibility = shadowEdge(kWidth);
  const PenumbraScales scales(visibility, std::nullopt);
  leaveNothingOnTheStack();
  const std::vector<float> row = seenWith(scales, 8, 1);
  for (int x = 0; x < kWidth; ++x) {
    ASSERT_GT(row[size_t(x)], 0) << x;
    ASSERT_LT(row[size_t(x)], 1) << x;
  }
  EXPECT_NEAR(row[kWidth / 2], .5F, .02F);
  EXPECT_TRUE(std::is_sorted(row.begin(), row.end()));
}

TEST(PenumbraScales, ASmallLampsShadowsHaveNarrowEdgesAlready) {
  const Image visibility = shadowEdge(20);
  const PenumbraScales scales(visibility, std::nullopt);
  // A quarter of a lamp of 4 pixels: what looks wider is no shadow's edge.
  EXPECT_NEAR(widthOf(seenWith(scales, 4, .01F)), 20, 1);
}

TEST(PenumbraScales, WhatIsSharpToThePixelStays) {
  const Image visibility = shadowEdge(.01);
  const PenumbraScales scales(visibility, std::nullopt);
  const std::vector<float> row = seenWith(scales, 8, 1);
  for (int x = 0; x < kWidth; ++x)
    ASSERT_EQ(row[static_cast<size_t>(x)], visibility.view().at(0, x, kHeight / 2));
}

TEST(PenumbraScales, TheEdgeOfAConeIsNoShadow) {
  const Image visibility = shadowEdge(20);
  LightCone cone;
  cone.x = -.2;
  cone.radiusA = .2;  // its edge is that line
  cone.radiusB = 10;
  const PenumbraScales scales(visibility, cone);
  EXPECT_NEAR(widthOf(seenWith(scales, 4, 1)), 20, 1);
}

TEST(LampSize, ShadowsOfALargerLampAreSofter) {
  const ShadowedWall wall(12);
  const SolvedSet edited = applyEdits(wall.set, sized({3, .3F}), wall.source());
  const auto seen = [&](const SolvedSet& set, int x) {
    return set.contributions[0].view().at(1, x, kHeight / 2) /
           wall.shadows->direct.view().at(1, x, kHeight / 2);
  };
  double ours = 0;
  double nothing = 0;
  for (int x = kWidth / 2 - 30; x < kWidth / 2 + 30; ++x) {
    const float truth = ramp(x + .5, 36);
    ours += std::abs(seen(edited, x) / seen(edited, kWidth - 60) - truth);  // but for the level
    nothing += std::abs(seen(wall.set, x) - truth);
  }
  EXPECT_LT(ours, .5 * nothing);
}

TEST(LampSize, LightThatHasBouncedIntoAShadowStays) {
  constexpr float kBounce = .1F;
  constexpr float kFound = .05F;  // a search that takes some of it for the lamp's
  for (const ShadowLabel inside : {ShadowLabel::Umbra, ShadowLabel::Unknown, ShadowLabel::Penumbra}) {
    ShadowedWall wall(12);
    std::replace(wall.shadows->labels.begin(), wall.shadows->labels.end(), ShadowLabel::Umbra, inside);
    Image& light = wall.set.contributions[0];
    for (size_t p = 0; p < light.pixelCount(); ++p) {
      float& seen = wall.shadows->visibility.plane(0)[p];
      seen = std::max(seen, kFound);
      for (int c = 0; c < 3; ++c) light.plane(c)[p] += kBounce * wall.shadows->direct.plane(c)[p];
    }
    const Image edited = applyEdits(wall.set, sized({.5F, .4F}), wall.source()).contributions[0].clone();
    const auto gain = [&](int x) {
      return edited.view().at(1, x, kHeight / 2) / light.view().at(1, x, kHeight / 2);
    };
    const float level = gain(kWidth - 60);
    const float left = gain(kWidth / 2 - 40) / level;
    const float most = inside == ShadowLabel::Penumbra ? kFound / kBounce : 0;  // that may go
    EXPECT_GT(left, .95F * (1 - most)) << static_cast<int>(inside);
  }
}

TEST(LampSize, ASoftboxThatGrowsLightsAsARealOneWould) {
  const test::LampPlace middle{-.1, .1, .7};
  constexpr double kDiameter = .3;
  // A softbox that is small beside its distance is nearly a point already: where it stands says more.
  for (const auto& [times, left] : {std::pair{.33F, .8F}, std::pair{3.F, .5F}}) {
    SolvedSet set = softboxSet(middle, kDiameter);
    auto lit = std::make_shared<LightShadows>();
    lit->visibility = Image(ImageSpec{kWidth, kHeight, {"Y"}, "data"}, 1.F);
    lit->labels = labelsOf(lit->visibility);
    lit->direct = set.contributions[0].clone();
    const SolvedSet truth = softboxSet(middle, times * kDiameter);
    const SolvedSet edited =
        applyEdits(set, sized({times, kDiameter / .7}), [&](const std::string& /*light*/) { return lit; });
    EXPECT_LT(test::meanError(edited.contributions[0], truth.contributions[0]),
              left * test::meanError(set.contributions[0], truth.contributions[0]))
        << times;
  }
}

TEST(LampSize, ChangesItsLightAloneAndOnlyWhereTheMaskIs) {
  const ShadowedWall wall(12);
  const Mask mask{{RectangleShape{100, 80, 160, 50, 0}, false}};
  const SolvedSet edited = applyEdits(wall.set, sized({4, .4F}, mask), wall.source());
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_EQ(edited.contributions[1].view().at(1, x, y), wall.set.contributions[1].view().at(1, x, y));
      if (x >= 99 && x <= 261 && y >= 79 && y <= 131) continue;
      ASSERT_EQ(edited.contributions[0].view().at(1, x, y), wall.set.contributions[0].view().at(1, x, y));
    }
}

TEST(LampSize, TilesGiveWhatTheWholePictureGives) {
  const ShadowedWall wall(12);
  ShadowedWall same(12);
  EditedSet edited(std::make_shared<const SolvedSet>(std::move(same.set)), wall.source());
  for (const float times : {3.F, 1.F, .5F, 8.F}) {
    const EditStack stack = sized({times, .4F});
    edited.setStack(stack);
    edited.update();
    const SolvedSet reference = applyEdits(wall.set, stack, wall.source());
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < reference.contributions[0].pixelCount(); ++p) {
        ASSERT_NEAR(edited.result().contributions[0].plane(c)[p], reference.contributions[0].plane(c)[p],
                    1e-6F);
        ASSERT_TRUE(std::isfinite(reference.contributions[0].plane(c)[p]) &&
                    reference.contributions[0].plane(c)[p] >= 0);
      }
  }
}

TEST(LampSize, BringsNoLightBackThatAnEditTookAway) {
  const ShadowedWall wall(12);
  EditStack stack;
  Edit less;
  less.lights = {"key"};
  less.energy = EnergyMode::Add;
  less.operation = FillOperation{0};
  stack.append(less);
  for (const auto& edit : sized({3, .4F}).edits) stack.append(*edit);
  const SolvedSet edited = applyEdits(wall.set, stack, wall.source());
  for (int x = 0; x < kWidth; ++x) {
    if (!(wall.set.contributions[0].view().at(1, x, kHeight / 2) > 0)) continue;
    ASSERT_EQ(edited.contributions[0].view().at(1, x, kHeight / 2), 0) << x;
  }
}

TEST(LampSize, AsksForShadowsOnlyWhereTheSizeChanges) {
  const ShadowedWall wall(12);
  EXPECT_NO_THROW(applyEdits(wall.set, sized({1, .4F})));
  EXPECT_THROW(applyEdits(wall.set, sized({2, .4F})), InputError);
  EXPECT_TRUE(usesShadows(*sized({2, .4F}).edits[0]));
}

TEST(LampSize, OfASpotLittleIsKnown) {
  const auto warned = [](const ShadowedWall& wall, float times) {
    return applyEdits(wall.set, sized({times, 0}), wall.source()).capture.warnings;
  };
  const ShadowedWall spot(12, {.25, 0, .8, .15});
  ASSERT_EQ(warned(spot, 3).size(), 1U);
  EXPECT_NE(warned(spot, 3)[0].find("\"key\" is a spot"), std::string::npos);
  EXPECT_TRUE(warned(spot, 1).empty());
  EXPECT_TRUE(warned(ShadowedWall(1e9), 3).empty());
}

}  // namespace
}  // namespace swaplight
