#include "core/solve/calibration/swap_shares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace swaplight {
namespace {

constexpr double kTrueScale = .35;

/// A surface whose pixels are lit by anything from one lamp alone to the other alone; a camera sees the gels'
/// contrast on it `times` as strong as on a white one.
void addSurface(std::vector<SwapContrast>& contrasts, std::array<int, 2> kind, int pixels, double times) {
  const Eigen::Vector3d direction = Eigen::Vector3d(.3, .5, .8).normalized();
  std::mt19937 random(unsigned(contrasts.size() + 1));
  std::normal_distribution<double> noise(0, .004);
  for (int j = 0; j < pixels; ++j) {
    const double share = std::cos(3.14159265 * (j + .5) / pixels);
    SwapContrast contrast;
    for (int c = 0; c < 3; ++c) contrast.value[c] = times * kTrueScale * share * direction[c] + noise(random);
    contrast.precision.setConstant(1 / (.004 * .004));
    contrast.kind = kind;
    contrasts.push_back(contrast);
  }
}

double scaleOf(const std::vector<SwapContrast>& contrasts) {
  const SwappedColorTuning tuning;
  return swapScale(contrasts, swapShares(contrasts, tuning), tuning);
}

TEST(SwapShares, HaveTheScaleOfMostSurfaces) {
  std::vector<SwapContrast> contrasts;
  addSurface(contrasts, {0, 0}, 2000, 1);
  addSurface(contrasts, {1, -1}, 1000, 1);
  EXPECT_NEAR(scaleOf(contrasts), kTrueScale, .02 * kTrueScale);
  addSurface(contrasts, {-5, 4}, 1000, 1.7);
  EXPECT_NEAR(scaleOf(contrasts), kTrueScale, .02 * kTrueScale) << "one of a deep colour does not decide";
}

TEST(SwapShares, OfASetTooMotleyToSortAreTakenTogether) {
  std::vector<SwapContrast> contrasts;
  for (int kind = 0; kind < 80; ++kind) addSurface(contrasts, {kind, 0}, 40, 1);
  EXPECT_NEAR(scaleOf(contrasts), kTrueScale, .02 * kTrueScale);
}

/// A surface in which both lamps mix everywhere says nothing of the scale.
TEST(SwapShares, DoNotShrinkBySurfacesThatBothLampsLight) {
  std::vector<SwapContrast> contrasts;
  addSurface(contrasts, {0, 0}, 2000, 1);
  addSurface(contrasts, {1, -1}, 6000, .5);
  EXPECT_NEAR(scaleOf(contrasts), kTrueScale, .02 * kTrueScale);
}

/// Photographs that are the same but for a few pixels: nothing surely differs.
TEST(SwapShares, OfPhotographsThatAreTheSameHaveNoScale) {
  std::vector<SwapContrast> contrasts;
  addSurface(contrasts, {0, 0}, 20, 1);
  for (size_t j = 0; j < 4000; ++j) {
    SwapContrast same;
    same.value.setZero();
    same.precision.setConstant(1 / (.004 * .004));
    same.kind = {int(j % 2), 1};
    contrasts.push_back(same);
  }
  EXPECT_EQ(scaleOf(contrasts), 0);
}

}  // namespace
}  // namespace swaplight
