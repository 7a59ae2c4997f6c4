// Shadows that are looked at and chosen one by one: outlines, thresholds by light, edits of one of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/edit/apply/edited_set.h"
#include "core/shadow/detect/detect_shadows.h"
#include "core/shadow/detect/shadow_preview.h"
#include "core/shadow/result/connected_shadow.h"

namespace swaplight {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 160;
constexpr int kLeft = 90, kRight = 230;  // the middles of two discs' shadows

// A floor under two lights; two discs hide the first, with soft rims, so many times as large.
std::shared_ptr<SolvedSet> twoDiscs(int times = 1) {
  auto set = std::make_shared<SolvedSet>();
  set->capture.lights = {{"key", Role::Key, Json::object()}, {"fill", Role::Fill, Json::object()}};
  for (int i = 0; i < 2; ++i)
    set->contributions.emplace_back(ImageSpec::rgb(kWidth * times, kHeight * times));
  for (int y = 0; y < kHeight * times; ++y)
    for (int x = 0; x < kWidth * times; ++x) {
      const float u = static_cast<float>(x) / static_cast<float>(times);
      const float v = static_cast<float>(y) / static_cast<float>(times);
      const float distance = std::min(std::hypot(u - kLeft, v - 80), std::hypot(u - kRight, v - 80));
      const float visible = std::clamp((distance - 30) / 8, 0.F, 1.F);
      for (int c = 0; c < 3; ++c) {
        set->contributions[0].span().at(c, x, y) = .5F * (.7F * visible + .02F);
        set->contributions[1].span().at(c, x, y) = .5F * (.3F + .1F * v / kHeight);
      }
    }
  updateBeta(*set);
  return set;
}

SolvedSet edited(const std::shared_ptr<SolvedSet>& set, const ShadowOperation& operation, Mask mask) {
  EditStack stack;
  Edit edit;
  edit.lights = {"key"};
  edit.operation = operation;
  edit.mask = std::move(mask);
  stack.append(std::move(edit));
  return applyEdits(*set, stack, shadowSource(set));
}

Mask chosenAt(int x, int y) {
  return {{ShadowShape{"key", true, x, y}, false}};
}

TEST(ChosenShadow, IsTheSameForEveryPixelOfIt) {
  const std::vector<LightShadows> found = detectShadows(*twoDiscs());
  const auto middle = connectedShadowAt(found[0], kLeft, 80);
  const auto side = connectedShadowAt(found[0], kLeft - 20, 90);
  ASSERT_TRUE(middle && side);
  EXPECT_EQ(middle->x, side->x);
  EXPECT_EQ(middle->y, side->y);
  EXPECT_NEAR(middle->x, kLeft, 3);
  EXPECT_NEAR(middle->y, 80, 3);
  EXPECT_NEAR(static_cast<double>(middle->pixels), 3.14 * 36 * 36, 500);
  EXPECT_FALSE(connectedShadowAt(found[0], 160, 10));
  EXPECT_FALSE(connectedShadowAt(found[0], -1, 10));
}

TEST(ChosenShadow, IsOutlinedWhereItIs) {
  const std::vector<LightShadows> found = detectShadows(*twoDiscs());
  const ShadowOutlines outlines = shadowOutlines(found[0].labels, kWidth);
  ASSERT_EQ(outlines.umbra.size(), 2U);
  ASSERT_EQ(outlines.penumbra.size(), 2U);
  for (const Outline& line : outlines.penumbra)
    for (const auto& [x, y] : line) {
      const float distance = std::min(std::hypot(x - kLeft, y - 80), std::hypot(x - kRight, y - 80));
      EXPECT_GT(distance, 28);
      EXPECT_LT(distance, 40);
    }
}

// A ring of shadow: ticks point into it from its outer border and from that of its hole.
TEST(ShadowTicks, LieOnTheShadowsSideOfItsBorderAndOfItsHoles) {
  constexpr int kSide = 120;
  std::vector<ShadowLabel> labels(kSide * kSide, ShadowLabel::Lit);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      if (const double r = std::hypot(x - 60, y - 60); r > 20 && r < 50)
        labels[static_cast<size_t>(y) * kSide + static_cast<size_t>(x)] = ShadowLabel::Umbra;
  const std::vector<Outline> outlines = shadowOutlines(labels, kSide).umbra;
  ASSERT_EQ(outlines.size(), 2U);
  size_t count = 0;
  for (const Outline& outline : outlines)
    for (const auto& [from, to] : shadowTicks(outline, 6, 4)) {
      const float foot = std::hypot(from[0] - 60.5F, from[1] - 60.5F);
      const float tip = std::hypot(to[0] - 60.5F, to[1] - 60.5F);
      EXPECT_GT(tip, 21) << "in the ring";
      EXPECT_LT(tip, 49);
      EXPECT_GT(std::abs(tip - foot), 2) << "upright on the border";
      ++count;
    }
  EXPECT_NEAR(static_cast<double>(count), 2 * 3.14 * (20 + 50) / 6, 8);
}

TEST(ShadowTicks, AreNotOnSpecks) {
  EXPECT_TRUE(shadowTicks({{1, 1}, {1, 2}, {2, 2}, {2, 1}}, 6, 4).empty());
  EXPECT_TRUE(shadowTicks({}, 6, 4).empty());
}

TEST(ChosenShadow, IsRemovedAsWhollyAsAllShadowsAreAndTheOtherStays) {
  const auto set = twoDiscs();
  const SolvedSet all = edited(set, {}, {});
  const SolvedSet one = edited(set, {}, chosenAt(kLeft + 10, 80));
  for (int y = 30; y < 130; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const auto at = [&](const SolvedSet& s) { return s.contributions[0].view().at(1, x, y); };
      ASSERT_FLOAT_EQ(at(one), x < 160 ? at(all) : at(*set)) << x << " " << y;
    }
}

TEST(ChosenShadow, IsSoftenedBeyondItsOutlineAndTheOtherStays) {
  const auto set = twoDiscs();
  const ShadowOperation soften{ShadowOperation::Kind::Soften, 1, 24, {1, 1, 1}};
  const SolvedSet all = edited(set, soften, {});
  const SolvedSet one = edited(set, soften, chosenAt(kLeft, 80));
  const auto at = [](const SolvedSet& s, int x) { return s.contributions[0].view().at(1, x, 80); };
  EXPECT_LT(at(all, kLeft + 40), .98F * at(*set, kLeft + 40));
  EXPECT_FLOAT_EQ(at(one, kLeft + 40), at(all, kLeft + 40));
  EXPECT_FLOAT_EQ(at(one, kRight - 40), at(*set, kRight - 40));
}

TEST(ChosenShadow, FollowsASliderToTheSameResultAsAFreshStart) {
  const auto set = twoDiscs();
  EditedSet live(set, shadowSource(set));
  EditStack stack;
  stack.append({});
  for (const float amount : {.2F, .9F, .4F}) {
    for (const auto kind : {ShadowOperation::Kind::Lighten, ShadowOperation::Kind::Soften}) {
      Edit edit;
      edit.lights = {"key"};
      edit.operation = ShadowOperation{kind, amount, static_cast<int>(40 * amount), {1, 1, 1}};
      edit.mask = chosenAt(kRight, 80);
      stack.replace(0, edit);
      live.setStack(stack);
      live.update();
      const SolvedSet fresh = applyEdits(*set, stack, shadowSource(set));
      for (size_t p = 0; p < fresh.contributions[0].pixelCount(); ++p)
        ASSERT_FLOAT_EQ(live.result().contributions[0].plane(0)[p], fresh.contributions[0].plane(0)[p]);
    }
  }
}

TEST(ShadowThresholds, AreOneALight) {
  const auto set = twoDiscs();
  ShadowOptions options;
  options.thresholds = {{"key", .25F}};
  const std::vector<LightShadows> found = detectShadows(*set, options);
  EXPECT_NEAR(found[0].threshold, .25F, 1e-4F);
  EXPECT_FLOAT_EQ(found[1].threshold, detectShadows(*set)[1].threshold);
  options.thresholds = {{"rim", .25F}};
  EXPECT_THROW(static_cast<void>(detectShadows(*set, options)), InputError);
}

TEST(ShadowThresholds, OfAStackAreFollowed) {
  const auto set = twoDiscs();
  ShadowOptions options;
  EditedSet edited(set, [&](const std::string& light) { return shadowSource(set, options)(light); });
  EditStack stack;
  Edit edit;
  edit.lights = {"key"};
  edit.operation = ShadowOperation{ShadowOperation::Kind::Deepen, 1, 12, {1, 1, 1}};
  stack.append(edit);
  edited.setStack(stack);
  edited.update();
  const auto darkened = [&] {
    double sum = 0;
    for (size_t p = 0; p < set->contributions[0].pixelCount(); ++p)
      sum += set->contributions[0].plane(0)[p] - edited.result().contributions[0].plane(0)[p];
    return sum;
  };
  const double before = darkened();
  options.thresholds = {{"key", .001F}};  // nothing is as dark
  stack.shadowThresholds = options.thresholds;
  edited.setStack(stack);
  edited.update();
  EXPECT_GT(before, 10);
  EXPECT_LT(darkened(), .1 * before);
}

TEST(ShadowPreview, SeesInASmallPictureWhatIsFoundInTheLargeOne) {
  const auto set = twoDiscs(6);  // 1920 x 960: shrunk twice
  const ShadowPreview preview(*set);
  const PreviewedShadows seen = preview.shadows(0, {});
  EXPECT_EQ(seen.scale, 2);
  const std::vector<LightShadows> found = detectShadows(*set);
  EXPECT_NEAR(stopsFromThreshold(preview.ownThreshold(0)), stopsFromThreshold(found[0].threshold), .5F);
  int both = 0, either = 0;
  for (int y = 0; y < kHeight * 6; ++y)
    for (int x = 0; x < kWidth * 6; ++x) {
      const size_t small =
          static_cast<size_t>(y / 2) * static_cast<size_t>(seen.width) + static_cast<size_t>(x / 2);
      const size_t large = static_cast<size_t>(y) * kWidth * 6 + static_cast<size_t>(x);
      const bool a = seen.labels[small] == ShadowLabel::Umbra;
      const bool b = found[0].labels[large] == ShadowLabel::Umbra;
      both += a && b;
      either += a || b;
    }
  EXPECT_GT(both, .85 * either);
}

TEST(ShadowPreview, HasAHistogramInWhichLitAndShadowStandApart) {
  const ShadowPreview preview(*twoDiscs());
  const ShadowHistogram& histogram = preview.histogram(0);
  const float threshold = stopsFromThreshold(preview.ownThreshold(0));
  float sum = 0, below = 0;
  for (size_t i = 0; i < ShadowHistogram::kBins; ++i) {
    const float stops =
        ShadowHistogram::kLowestStops + (static_cast<float>(i) + .5F) / ShadowHistogram::kBins *
                                            (ShadowHistogram::kHighestStops - ShadowHistogram::kLowestStops);
    sum += histogram.share[i];
    if (stops < threshold) below += histogram.share[i];
  }
  EXPECT_NEAR(sum, 1, 1e-4F);
  EXPECT_NEAR(below, 2 * 3.14F * 33 * 33 / (kWidth * kHeight), .04F);
}

TEST(ShadowPreview, FindsMoreShadowAboveAHigherThreshold) {
  const ShadowPreview preview(*twoDiscs());
  const auto shadow = [&](float threshold) {
    const auto labels = preview.shadows(0, threshold).labels;
    return std::count_if(labels.begin(), labels.end(),
                         [](ShadowLabel label) { return label != ShadowLabel::Lit; });
  };
  EXPECT_GT(shadow(.8F), shadow(.1F));
}

}  // namespace
}  // namespace swaplight
