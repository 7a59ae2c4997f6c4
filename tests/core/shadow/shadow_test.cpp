#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/edit/apply/edited_set.h"
#include "core/shadow/detect/detect_shadows.h"
#include "core/shadow/result/shadow_file.h"

namespace swaplight {
namespace {

constexpr int kWidth = 240;
constexpr int kHeight = 160;

// A checked floor under two lights of uneven brightness; a disc hides the first light, with a soft rim.
struct Floor {
  SolvedSet set;
  Image unshadowed{ImageSpec::rgb(kWidth, kHeight)};
  std::vector<float> visible;
};

Floor shadowedFloor() {
  Floor floor;
  floor.set.capture.lights = {{"key", Role::Key, Json::object()}, {"fill", Role::Fill, Json::object()}};
  for (int i = 0; i < 2; ++i) floor.set.contributions.emplace_back(ImageSpec::rgb(kWidth, kHeight));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float albedo = (x / 20 + y / 20) % 2 ? .8f : .2f;
      const float key = .6f + .2f * static_cast<float>(x) / kWidth;
      const float fill = .3f + .1f * static_cast<float>(y) / kHeight;
      const float distance = std::hypot(static_cast<float>(x) - 120, static_cast<float>(y) - 80);
      const float visible = std::clamp((distance - 30) / 6, 0.f, 1.f);
      floor.visible.push_back(visible);
      for (int c = 0; c < 3; ++c) {
        floor.unshadowed.span().at(c, x, y) = albedo * (key + .02f);
        floor.set.contributions[0].span().at(c, x, y) = albedo * (key * visible + .02f);
        floor.set.contributions[1].span().at(c, x, y) = albedo * fill;
      }
    }
  updateBeta(floor.set);
  return floor;
}

size_t pixelAt(int x, int y) {
  return static_cast<size_t>(y) * kWidth + static_cast<size_t>(x);
}

TEST(Shadows, AreDrawnOverPixelsThatAreNoNumbers) {
  Floor floor = shadowedFloor();
  floor.set.ambient = Image(ImageSpec::rgb(kWidth, kHeight), 0);
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  const float broken[] = {std::numeric_limits<float>::quiet_NaN(), kInfinite, -kInfinite};
  for (int x = 0; x < 3; ++x) floor.set.ambient->span().at(0, 200 + x, 140) = broken[x];
  const std::vector<LightShadows> shadows = detectShadows(floor.set);
  const Image drawn = drawShadowOutlines(floor.set, {{"key", &shadows[0]}});
  for (int x = 0; x < 3; ++x) {
    EXPECT_GE(drawn.view().at(0, 200 + x, 140), 0);
    EXPECT_LE(drawn.view().at(0, 200 + x, 140), 1);
  }
}

TEST(Shadows, ADiscsShadowIsFoundAndPrintedChecksAreNone) {
  const Floor floor = shadowedFloor();
  const std::vector<LightShadows> found = detectShadows(floor.set);
  ASSERT_EQ(found.size(), 2U);
  int both = 0;
  int either = 0;
  double error = 0;
  for (size_t p = 0; p < floor.visible.size(); ++p) {
    const bool umbra = found[0].labels[p] == ShadowLabel::Umbra;
    both += umbra && floor.visible[p] < .02f;
    either += umbra || floor.visible[p] < .02f;
    error += std::abs(found[0].visibility.plane(0)[p] - floor.visible[p]);
  }
  EXPECT_GT(both, .85 * either);
  EXPECT_LT(error / static_cast<double>(floor.visible.size()), .03);
  EXPECT_EQ(found[0].labels[pixelAt(10, 10)], ShadowLabel::Lit);
  EXPECT_EQ(found[0].labels[pixelAt(30, 10)], ShadowLabel::Lit);
}

TEST(Shadows, ALightThatCastsNoneHasNone) {
  const std::vector<LightShadows> found = detectShadows(shadowedFloor().set);
  for (const ShadowLabel label : found[1].labels) ASSERT_EQ(label, ShadowLabel::Lit);
}

// Two lights, each the same everywhere.
SolvedSet evenSet(int width, int height, float key, float fill) {
  SolvedSet set;
  set.capture.lights = {{"key", Role::Key, Json::object()}, {"fill", Role::Fill, Json::object()}};
  for (const float light : {key, fill}) {
    Image& image = set.contributions.emplace_back(ImageSpec::rgb(width, height));
    for (int c = 0; c < 3; ++c) std::fill_n(image.plane(c), image.pixelCount(), light);
  }
  updateBeta(set);
  return set;
}

TEST(Shadows, EvenLightHasNoneInPicturesOfAnySize) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 40}, {40, 1}, {2, 3}, {64, 48}}) {
    const std::vector<LightShadows> found = detectShadows(evenSet(width, height, .5F, .2F));
    for (const LightShadows& light : found)
      for (const ShadowLabel label : light.labels)
        ASSERT_EQ(label, ShadowLabel::Lit) << width << " " << height;
  }
}

TEST(Shadows, ALightThatGivesNothingIsAllUmbra) {
  const std::vector<LightShadows> found = detectShadows(evenSet(64, 48, .5F, 0));
  for (const ShadowLabel label : found[0].labels) ASSERT_EQ(label, ShadowLabel::Lit);
  for (const ShadowLabel label : found[1].labels) ASSERT_EQ(label, ShadowLabel::Umbra);
}

TEST(Shadows, APictureOnItsSideHasTheSame) {
  const SolvedSet set = shadowedFloor().set;
  SolvedSet turned = evenSet(kHeight, kWidth, 0, 0);
  for (size_t i = 0; i < 2; ++i)
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        for (int c = 0; c < 3; ++c)
          turned.contributions[i].span().at(c, y, x) = set.contributions[i].plane(c)[pixelAt(x, y)];
  updateBeta(turned);
  const std::vector<LightShadows> upright = detectShadows(set);
  const std::vector<LightShadows> lying = detectShadows(turned);
  double difference = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      difference +=
          std::abs(upright[0].visibility.plane(0)[pixelAt(x, y)] -
                   lying[0].visibility.plane(0)[static_cast<size_t>(x) * kHeight + static_cast<size_t>(y)]);
  EXPECT_LT(difference / (kWidth * kHeight), .002);
}

TEST(Shadows, BlackPixelsAreUnknown) {
  Floor floor = shadowedFloor();
  for (Image& t : floor.set.contributions)
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) t.span().at(c, x, y) = 0;
  updateBeta(floor.set);
  const std::vector<LightShadows> found = detectShadows(floor.set);
  EXPECT_EQ(found[0].labels[pixelAt(15, 15)], ShadowLabel::Unknown);
  EXPECT_EQ(found[1].labels[pixelAt(15, 15)], ShadowLabel::Unknown);
}

TEST(Shadows, AThresholdThatIsGivenIsUsed) {
  ShadowOptions options;
  options.threshold = .25f;
  const std::vector<LightShadows> found = detectShadows(shadowedFloor().set, options);
  EXPECT_NEAR(found[0].threshold, .25f, 1e-4f);
}

SolvedSet edited(const Floor& floor, const ShadowOperation& operation) {
  const auto set = std::make_shared<SolvedSet>(shadowedFloor().set);
  EditStack stack;
  Edit edit;
  edit.lights = {"key"};
  edit.operation = operation;
  stack.append(std::move(edit));
  EXPECT_EQ(floor.set.width(), set->width());
  return applyEdits(*set, stack, shadowSource(set));
}

TEST(Shadows, RemovingAShadowBringsBackTheFloor) {
  const Floor floor = shadowedFloor();
  const SolvedSet without = edited(floor, {});
  double error = 0;
  int count = 0;
  for (size_t p = 0; p < floor.visible.size(); ++p)
    if (floor.visible[p] < 1) {
      const float truth = floor.unshadowed.plane(1)[p];
      error += std::abs(without.contributions[0].plane(1)[p] - truth) / truth;
      ++count;
    }
  EXPECT_LT(error / count, .06);
  // The other light stays, and so does what is lit.
  EXPECT_FLOAT_EQ(without.contributions[1].plane(1)[pixelAt(120, 80)],
                  floor.set.contributions[1].plane(1)[pixelAt(120, 80)]);
  EXPECT_FLOAT_EQ(without.contributions[0].plane(1)[pixelAt(10, 10)],
                  floor.set.contributions[0].plane(1)[pixelAt(10, 10)]);
}

TEST(Shadows, ADeepenedShadowIsDarkerAndARecoloredOneHasTheColor) {
  const Floor floor = shadowedFloor();
  using Kind = ShadowOperation::Kind;
  const size_t middle = pixelAt(120, 80);
  const float before = floor.set.contributions[0].plane(0)[middle];
  EXPECT_LT(edited(floor, {Kind::Deepen, .5f}).contributions[0].plane(0)[middle], .6f * before);
  const SolvedSet red = edited(floor, {Kind::Recolor, 1, 12, {1, 0, 0}});
  EXPECT_GT(red.contributions[0].plane(0)[middle], 5 * before);
  EXPECT_NEAR(red.contributions[0].plane(2)[middle], before, 1e-4f);
}

TEST(Shadows, ASoftenedShadowIsWiderAndASharpenedOneSteeper) {
  const Floor floor = shadowedFloor();
  using Kind = ShadowOperation::Kind;
  const auto profile = [&](const SolvedSet& set, int x) {
    const size_t p = pixelAt(x, 80);
    return set.contributions[0].plane(0)[p] / floor.unshadowed.plane(0)[p];
  };
  const auto steepest = [&](const SolvedSet& set) {
    float step = 0;
    for (int x = 140; x < 170; ++x) step = std::max(step, profile(set, x + 1) - profile(set, x));
    return step;
  };
  const float as = steepest(floor.set);
  EXPECT_LT(steepest(edited(floor, {Kind::Soften, 1, 16})), .9f * as);
  EXPECT_GT(steepest(edited(floor, {Kind::Sharpen, 1})), 1.3f * as);
}

TEST(Shadows, ALightThatTheSetDoesNotHaveIsNamed) {
  const auto set = std::make_shared<SolvedSet>(shadowedFloor().set);
  EXPECT_THROW(static_cast<void>(shadowSource(set)("rim")), InputError);
}

}  // namespace
}  // namespace swaplight
