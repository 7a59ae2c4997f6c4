#include "core/edit/pool/spot_pool.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/edit/apply/edited_set.h"
#include "tests/support/lamp_set.h"

namespace swaplight {
namespace {

constexpr int kWidth = 320, kHeight = 180;

/// A spot before a wall; a pole's shadow across its pool. Its visibility is that of the light: what lies
/// outside the cone is as dark as the shadow.
struct Spot {
  std::shared_ptr<SolvedSet> set =
      std::make_shared<SolvedSet>(test::lampSet(kWidth, kHeight, {0, 0, .8, .2}));
  std::shared_ptr<LightShadows> shadows = std::make_shared<LightShadows>();

  Spot() {
    shadows->visibility = Image(ImageSpec{kWidth, kHeight, {"Y"}, "data"});
    shadows->direct = Image(ImageSpec::rgb(kWidth, kHeight));
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const double px = (x + .5) / kWidth - .5, py = (.5 * kHeight - (y + .5)) / kWidth;
        const bool seen = std::hypot(px, py) < .16 && !isPole(x);
        shadows->visibility.span().at(0, x, y) = seen ? 1.F : 0.F;
        for (int c = 0; c < 3; ++c) {
          shadows->direct.span().at(c, x, y) = .3F;
          if (isPole(x)) set->contributions[0].span().at(c, x, y) = 0;
        }
      }
    updateBeta(*set);
  }
  static bool isPole(int x) { return x >= 170 && x < 178; }

  [[nodiscard]] float greenAfter(const Mask& mask, int x, int y) const {
    EditStack stack;
    Edit edit;
    edit.lights = {"key"};
    edit.operation = ShadowOperation{};
    edit.mask = mask;
    stack.edits.push_back(std::make_shared<const Edit>(edit));
    return applyEdits(*set, stack, [this](const std::string&) { return shadows; })
        .contributions[0]
        .view()
        .at(1, x, y);
  }
};

TEST(SpotPool, IsWhereTheConeIsAndNothingWithoutOne) {
  const Spot spot;
  const auto pool = spotPool(*spot.set, 0);
  ASSERT_TRUE(pool);
  EXPECT_EQ(pool->view().at(0, 160, 90), 1);
  EXPECT_EQ(pool->view().at(0, 174, 90), 1) << "in the shadow";
  EXPECT_EQ(pool->view().at(0, 230, 90), 0);
  EXPECT_FALSE(spotPool(*spot.set, 1));
  EXPECT_FALSE(spotPool(*spot.set, 7));
}

TEST(SpotPool, ShadowsAreFilledInIt) {
  const Spot spot;
  EXPECT_NEAR(spot.greenAfter({}, 174, 90), .3F, 1e-5F);
  EXPECT_EQ(spot.greenAfter({}, 230, 90), spot.set->contributions[0].view().at(1, 230, 90));
}

TEST(SpotPool, WhatAMaskNamesIsFilledAnywhere) {
  const Spot spot;
  EXPECT_GT(spot.greenAfter({{RectangleShape{220, 80, 20, 20, 0}, false}}, 230, 90), .29F);
}

}  // namespace
}  // namespace swaplight
