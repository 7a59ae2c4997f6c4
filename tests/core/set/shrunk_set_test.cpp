#include "core/set/shrunk_set.h"

#include <gtest/gtest.h>

namespace swaplight {
namespace {

/// One light; a pixel in four is black and says nothing of its own light.
SolvedSet speckledSet(float error, float light) {
  constexpr int kSide = 8;
  SolvedSet set;
  set.capture.lights.push_back({"key", Role::Other, {}});
  set.contributions.emplace_back(ImageSpec::rgb(kSide, kSide), light);
  set.quality = Image(ImageSpec{kSide, kSide, {"residual", "sigma", "flags", "model"}, "data"});
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const bool black = x % 2 == 0 && y % 2 == 0;
      if (black)
        for (int c = 0; c < 3; ++c) set.contributions[0].span().at(c, x, y) = 1e-6F * light;
      set.quality.span().at(kSigma, x, y) = error / (black ? 1e-6F * light : light);
    }
  updateBeta(set);
  return set;
}

TEST(ShrunkSet, IsAsMuchSurerAsItsPixelsAreMeansOfMore) {
  const SolvedSet small = shrunkSet(speckledSet(.001F, 1), 4, 4);
  ASSERT_EQ(small.contributions[0].view().at(1, 2, 2), .75F + .25F * 1e-6F);
  EXPECT_NEAR(small.quality.view().at(kSigma, 2, 2), .001F / .75F / 2, 1e-5F)
      << "the errors' mean, and not the mean of shares in next to no light";
}

TEST(ShrunkSet, TakesNoLightForSureThatMayBeNoiseAlone) {
  const SolvedSet small = shrunkSet(speckledSet(1, .4F), 4, 4);
  EXPECT_NEAR(small.quality.view().at(kSigma, 2, 2) * small.contributions[0].view().at(1, 2, 2), 1, 1e-5F);
}

}  // namespace
}  // namespace swaplight
