#include "core/shadow/detect/enlarged_shadows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/image/shrunk_image.h"
#include "core/set/shrunk_set.h"
#include "core/shadow/detect/detect_shadows.h"

namespace swaplight {
namespace {

constexpr int kWidth = 240, kHeight = 160, kFactor = 2;
constexpr float kBounce = .04F;

/// Visible to the left of a slanted border, half a pixel wide.
float visibilityAt(int x, int y) {
  return std::clamp(110.3F + .31F * float(y) - float(x), 0.F, 1.F);
}

/// A fine print.
float albedoAt(int x, int y) {
  return .35F + .25F * float((x / 3 + y / 5) % 3);
}

/// A key whose shadow has some bounced light in it, and a fill that falls off across the picture.
SolvedSet printedSet() {
  SolvedSet set;
  for (const char* name : {"key", "fill"}) {
    set.capture.lights.push_back({name, Role::Other, {}});
    set.contributions.emplace_back(ImageSpec::rgb(kWidth, kHeight));
  }
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c) {
        const float fill = .3F + .2F * float(x) / kWidth;
        const float key = visibilityAt(x, y) * .8F + kBounce;
        set.contributions[0].span().at(c, x, y) = albedoAt(x, y) * key;
        set.contributions[1].span().at(c, x, y) = albedoAt(x, y) * fill;
      }
  updateBeta(set);
  return set;
}

/// What a search that is always right would find at the size of `small`.
std::vector<LightShadows> foundOn(const SolvedSet& small) {
  Image visibility(ImageSpec{kWidth, kHeight, {"Y"}});
  Image direct(ImageSpec::rgb(kWidth, kHeight));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      visibility.span().at(0, x, y) = visibilityAt(x, y);
      for (int c = 0; c < 3; ++c) direct.span().at(c, x, y) = .8F * albedoAt(x, y);
    }
  LightShadows key;
  key.visibility = shrunkImage(visibility, small.width(), small.height());
  key.direct = shrunkImage(direct, small.width(), small.height());
  LightShadows fill;
  fill.visibility = Image(key.visibility.spec());
  fill.direct = small.contributions[1].clone();
  for (size_t p = 0; p < small.beta.pixelCount(); ++p) {
    key.labels.push_back(key.visibility.plane(0)[p] < .5F ? ShadowLabel::Umbra : ShadowLabel::Lit);
    fill.visibility.plane(0)[p] = 1;
  }
  key.labels.front() = ShadowLabel::Unknown;
  fill.labels.assign(small.beta.pixelCount(), ShadowLabel::Lit);
  std::vector<LightShadows> found;
  found.push_back(std::move(key));
  found.push_back(std::move(fill));
  return found;
}

struct Enlarged {
  SolvedSet set = printedSet();
  std::vector<LightShadows> shadows;
  Enlarged() {
    const SolvedSet small = shrunkSet(set, kWidth / kFactor, kHeight / kFactor);
    shadows = enlargedShadows(set, small, foundOn(small), {});
  }
};

TEST(EnlargedShadows, HaveTheirBordersWhereTheSetHasThem) {
  const Enlarged made;
  double error = 0, worst = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double off = std::abs(made.shadows[0].visibility.view().at(0, x, y) - visibilityAt(x, y));
      error += off / kHeight;
      worst = std::max(worst, off);
    }
  EXPECT_LT(error, .25) << "pixels of border a row, where half the size repeated has .5";
  EXPECT_LT(worst, .4);
}

TEST(EnlargedShadows, AreExactAwayFromBorders) {
  const Enlarged made;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      if (std::abs(110.8F + .31F * float(y) - float(x)) < 4 * kFactor) continue;
      ASSERT_EQ(made.shadows[0].visibility.view().at(0, x, y), visibilityAt(x, y)) << x << ", " << y;
      ASSERT_EQ(made.shadows[1].visibility.view().at(0, x, y), 1);
    }
}

TEST(EnlargedShadows, FillWithTheGrainOfTheSet) {
  const Enlarged made;
  double square = 0, power = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double whole = (.8 + kBounce) * albedoAt(x, y);
      const double filled =
          made.set.contributions[0].view().at(1, x, y) +
          (1 - made.shadows[0].visibility.view().at(0, x, y)) * made.shadows[0].direct.view().at(1, x, y);
      square += std::pow(filled - whole, 2);
      power += whole * whole;
    }
  EXPECT_LT(std::sqrt(square / power), .06);
}

/// Where another light's shadow ends in this one's the other lights jump, and what is filled does not.
TEST(EnlargedShadows, FillEvenlyAcrossTheShadowsOfOtherLights) {
  for (const int border : {120, 121}) {
    SolvedSet set = printedSet();
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        for (int c = 0; c < 3; ++c) {
          set.contributions[0].span().at(c, x, y) = .4F * (visibilityAt(x, y) * .8F + kBounce);
          set.contributions[1].span().at(c, x, y) = .4F * (x + y / 9 < border + 8 ? .01F : .5F);
        }
    const SolvedSet small = shrunkSet(set, kWidth / kFactor, kHeight / kFactor);
    std::vector<LightShadows> found = foundOn(small);
    for (int c = 0; c < 3; ++c) std::fill_n(found[0].direct.plane(c), small.beta.pixelCount(), .4F * .8F);
    const std::vector<LightShadows> shadows = enlargedShadows(set, small, std::move(found), {});
    for (int y = 4; y < kHeight - 4; ++y)
      for (int x = 4; x < kWidth - 4; ++x) {
        const float filled =
            set.contributions[0].view().at(1, x, y) +
            (1 - shadows[0].visibility.view().at(0, x, y)) * shadows[0].direct.view().at(1, x, y);
        ASSERT_NEAR(filled, .4F * .84F, .12F * .4F) << x << ", " << y;
      }
  }
}

TEST(EnlargedShadows, KeepWhatCannotBeTold) {
  const Enlarged made;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x)
      EXPECT_EQ(made.shadows[0].labels[size_t(y * kWidth + x)] == ShadowLabel::Unknown,
                x < kFactor && y < kFactor);
}

/// Found at a fraction of the size, marks and all.
TEST(EnlargedShadows, AreWhatALargeSetGets) {
  constexpr int kWide = 2500, kLow = 60;
  SolvedSet set;
  for (const char* name : {"key", "fill"}) {
    set.capture.lights.push_back({name, Role::Other, {}});
    set.contributions.emplace_back(ImageSpec::rgb(kWide, kLow));
  }
  for (int y = 0; y < kLow; ++y)
    for (int x = 0; x < kWide; ++x)
      for (int c = 0; c < 3; ++c) {
        set.contributions[0].span().at(c, x, y) = x < 1501 ? .8F : .02F;
        set.contributions[1].span().at(c, x, y) = .3F;
      }
  updateBeta(set);
  ShadowOptions options;
  options.marks["key"] = {{ShadowMark::Kind::Shadow, 2401, 59}};
  const std::vector<LightShadows> shadows = detectShadows(set, options);
  const LightShadows& key = shadows[0];
  ASSERT_EQ(key.visibility.width(), kWide);
  ASSERT_EQ(key.labels.size(), size_t(kWide) * kLow);
  int first = 0;
  while (first < kWide && key.labels[size_t(30 * kWide + first)] != ShadowLabel::Umbra) ++first;
  EXPECT_NEAR(first, 1501, 3);
  EXPECT_EQ(key.labels[size_t(59 * kWide + 2401)], ShadowLabel::Umbra) << "marks are obeyed";
}

}  // namespace
}  // namespace swaplight
