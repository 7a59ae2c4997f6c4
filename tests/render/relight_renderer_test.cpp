#include "render/relight_renderer.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "core/relight/relight.h"
#include "tests/render/gl_test.h"

namespace swaplight {
namespace {

/// The largest difference of two pictures, and where it lies. Pixels that are not finite must be so in both.
struct Worst {
  float difference = 0;
  std::string where;
};

Worst worstDifference(const Image& a, const Image& b) {
  Worst worst;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p) {
      const float x = a.plane(c)[p], y = b.plane(c)[p];
      const bool same = (std::isnan(x) && std::isnan(y)) || x == y;
      const float difference = same ? 0 : std::abs(x - y);
      if (difference <= worst.difference) continue;
      const size_t width = static_cast<size_t>(a.width());
      worst = {std::isnan(difference) ? std::numeric_limits<float>::infinity() : difference,
               fmt::format("channel {} of pixel {}, {}: {} and {}", c, p % width, p / width, x, y)};
    }
  return worst;
}

class RelightRendererTest : public GlTest {};

TEST_F(RelightRendererTest, EqualsTheCpuFrameForManyLightsAtFullHd) {
  for (const int lights : {2, 3, 4, 8, 11, 16}) {
    const SolvedSet set = randomSet(1920, 1080, lights, lights == 3);
    const std::vector<Rgb> factors = variedFactors(lights);
    RelightRenderer renderer(set);
    renderer.relight(factors, 0.7F);
    const Worst worst = worstDifference(renderer.readback(), relight(set, factors, 0.7F));
    EXPECT_LE(worst.difference, 2e-3F) << lights << " lights, " << worst.where;
    RecordProperty(fmt::format("worst{}", lights), fmt::format("{}", worst.difference));
  }
}

TEST_F(RelightRendererTest, AddsFurtherPassesForMoreLightsThanOnePassTakes) {
  const SolvedSet set = randomSet(320, 200, 11, true);
  const std::vector<Rgb> factors = variedFactors(11);
  RelightRenderer renderer(set, {.lightsPerPass = 4});
  renderer.relight(factors, 1);
  const Worst worst = worstDifference(renderer.readback(), relight(set, factors, 1));
  EXPECT_LE(worst.difference, 4e-3F) << worst.where;  // every pass rounds to half
}

TEST_F(RelightRendererTest, CarriesNegativeInfiniteAndUndefinedPixelsAsTheCpuDoes) {
  SolvedSet set = randomSet(256, 4, 2);
  for (int c = 0; c < 3; ++c) {
    float* ramp = set.contributions[0].plane(c);
    for (int x = 0; x < 256; ++x) ramp[x] = -1 + 3 * static_cast<float>(x) / 255;
    ramp[256] = std::numeric_limits<float>::quiet_NaN();
    ramp[257] = std::numeric_limits<float>::infinity();
    ramp[258] = -std::numeric_limits<float>::infinity();
  }
  const std::vector<Rgb> factors{{1, 0.5F, 0.9F}, {0.25F, 1, 0.5F}};
  RelightRenderer renderer(set);
  renderer.relight(factors);
  const Image frame = renderer.readback();
  const Worst worst = worstDifference(frame, relight(set, factors));
  EXPECT_LE(worst.difference, 2e-3F) << worst.where;
  EXPECT_TRUE(std::isnan(frame.plane(0)[256]));
  EXPECT_EQ(frame.plane(0)[257], std::numeric_limits<float>::infinity());
}

TEST_F(RelightRendererTest, LightThatHalfCannotHoldIsNoInfinityWhichWouldBeUndefinedWhereItIsOff) {
  SolvedSet set = randomSet(64, 4, 2);
  for (int c = 0; c < 3; ++c) {
    set.contributions[0].plane(c)[5] = 1e6F;
    set.contributions[0].plane(c)[6] = -std::numeric_limits<float>::max();
  }
  const std::vector<Rgb> off{{0, 0, 0}, {1, 1, 1}};
  RelightRenderer renderer(set);
  renderer.relight(off);
  const Worst worst = worstDifference(renderer.readback(), relight(set, off));
  EXPECT_LE(worst.difference, 2e-3F) << worst.where;
  renderer.relight(std::vector<Rgb>{{0.5F, 0.5F, 0.5F}, {0, 0, 0}});
  EXPECT_EQ(renderer.readback().plane(0)[5], 32752) << "half of the brightest";
  EXPECT_EQ(renderer.readback().plane(0)[6], -32752);
}

TEST_F(RelightRendererTest, TiledEqualsUntiledToTheBit) {
  const SolvedSet set = randomSet(700, 530, 3, true);
  const std::vector<Rgb> factors = variedFactors(3);
  RelightRenderer whole(set);
  whole.relight(factors, 0.5F);
  for (const int side : {256, 300, 512, 100}) {
    RelightRenderer tiled(set, {.maxTextureSide = side});
    EXPECT_GT(tiled.frame().tiles.size(), 1U);
    tiled.relight(factors, 0.5F);
    EXPECT_EQ(worstDifference(tiled.readback(), whole.readback()).difference, 0) << side;
  }
}

TEST_F(RelightRendererTest, ReplacesOnlyTheRectangleThatChanged) {
  const SolvedSet set = randomSet(600, 400, 2);
  SolvedSet painted = randomSet(600, 400, 2);
  const Image dab = randomImage(120, 90, 0.5F, 77);
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < 90; ++y)
      std::copy_n(dab.view().row(c, y), 120, painted.contributions[1].span().row(c, 200 + y) + 230);
  const std::vector<Rgb> factors = variedFactors(2);
  RelightRenderer updated(set, {.maxTextureSide = 256});
  updated.updateContribution(1, dab.view(), 230, 200);
  updated.relight(factors);
  RelightRenderer fresh(painted);
  fresh.relight(factors);
  EXPECT_EQ(worstDifference(updated.readback(), fresh.readback()).difference, 0);
  EXPECT_THROW(updated.updateContribution(1, dab.view(), 500, 0), std::logic_error);
  EXPECT_THROW(updated.updateContribution(2, dab.view(), 0, 0), std::logic_error);
}

TEST_F(RelightRendererTest, LightsThatAreOffLeaveBlack) {
  const SolvedSet set = randomSet(64, 64, 2, true);
  RelightRenderer renderer(set);
  renderer.relight(std::vector<Rgb>(2, Rgb(0)), 0);
  EXPECT_EQ(worstDifference(renderer.readback(), Image(ImageSpec::rgb(64, 64), 0)).difference, 0);
}

TEST_F(RelightRendererTest, SaysInWordsThatASetDoesNotFit) {
  const SolvedSet set = randomSet(512, 512, 4);
  try {
    const RelightRenderer renderer(set, {.memoryLimit = 4 << 20});
    FAIL() << "no error";
  } catch (const ResourceError& error) {
    EXPECT_STREQ(
        error.what(),
        "4 lights at 512 x 512 need 10 MB of graphics memory, the limit is 4 MB. Use a smaller picture, or "
        "relight on the processor");
  }
}

TEST_F(RelightRendererTest, LeavesTheStateOfTheContextAsItWas) {
  const SolvedSet set = randomSet(40, 30, 3);
  const std::vector<Rgb> factors = variedFactors(3);
  RelightRenderer renderer(set, {.lightsPerPass = 1});
  const GlStateSnapshot before;
  renderer.relight(factors);
  const Image frame = renderer.readback();
  EXPECT_EQ(before, GlStateSnapshot());
}

}  // namespace
}  // namespace swaplight
