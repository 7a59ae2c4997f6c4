#include "core/solve/auto/share_pooling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace swaplight {
namespace {

constexpr int kWidth = 61;  // no multiple of anything
constexpr int kHeight = 45;
constexpr float kSigma = 0.05F;

/// Two lights: .02 and .98 on the left, .6 and .4 on the right of column 30; noise of kSigma.
struct Scene {
  Image shares{ImageSpec{kWidth, kHeight, {"a", "b"}, "data"}};
  Image variance{ImageSpec{kWidth, kHeight, {"v"}, "data"}};
  Image guide{ImageSpec{kWidth, kHeight, {"g"}, "data"}};
  Image pooled{ImageSpec{kWidth, kHeight, {"a", "b"}, "data"}};
  Image left{ImageSpec{kWidth, kHeight, {"v"}, "data"}};

  Scene() {
    std::mt19937 random(3);
    std::normal_distribution<float> gauss;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const float a = truth(x) + kSigma * gauss(random);
        shares.span().at(0, x, y) = a;
        shares.span().at(1, x, y) = 1 - a;
        variance.span().at(0, x, y) = kSigma * kSigma;
        guide.span().at(0, x, y) = .5F;
      }
  }
  static float truth(int x) { return x < 30 ? .02F : .6F; }
  void pool(const SharePooling& options = {}) {
    poolShares(planesOf(shares), variance.view(), guide.view(), options, planesOf(pooled), left.span());
  }
  [[nodiscard]] double error(int from, int to) const {
    double sum = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = from; x < to; ++x) sum += std::pow(pooled.view().at(0, x, y) - truth(x), 2);
    return std::sqrt(sum / (kHeight * (to - from)));
  }
};

TEST(SharePooling, TakesMostOfTheNoiseAndSaysWhatIsLeft) {
  Scene scene;
  scene.pool();
  EXPECT_LT(scene.error(0, 30), .45 * kSigma);
  double predicted = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) predicted += scene.left.view().at(0, x, y) / (kWidth * kHeight);
  EXPECT_LT(std::sqrt(predicted), kSigma);
  EXPECT_GT(std::sqrt(predicted), scene.error(0, kWidth)) << "it never promises more than it gives";
}

TEST(SharePooling, LeavesAnEdgeOfTheSharesWhereItIs) {
  Scene scene;
  scene.pool();
  EXPECT_LT(scene.error(28, 32), .6 * kSigma);
}

TEST(SharePooling, DoesNotMixWhatTheGuideTellsApart) {
  Scene scene;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      // One row of another kind, only a little darker in share.
      if (y != 20) continue;
      scene.guide.span().at(0, x, y) = .1F;
      scene.shares.span().at(0, x, y) = .02F;
      scene.shares.span().at(1, x, y) = .98F;
    }
  scene.pool();
  for (int x = 0; x < kWidth; ++x) EXPECT_NEAR(scene.pooled.view().at(0, x, 20), .02F, 1e-6F);
}

TEST(SharePooling, HasTheRightMeanInAShadowBecauseItsSharesAreSigned) {
  Scene scene;
  scene.pool();
  double mean = 0;
  double cut = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < 28; ++x) {
      mean += scene.pooled.view().at(0, x, y) / (28 * kHeight);
      cut += std::max(scene.shares.view().at(0, x, y), 0.0F) / (28 * kHeight);
    }
  EXPECT_NEAR(mean, .02, .004);
  EXPECT_GT(cut, .028) << "what shares that were cut off first would give";
}

TEST(SharePooling, LeavesAloneWhatIsCertain) {
  Scene scene;
  std::fill_n(scene.variance.plane(0), scene.variance.pixelCount(), 0.0F);
  scene.pool();
  for (size_t p = 0; p < scene.shares.pixelCount(); ++p)
    EXPECT_FLOAT_EQ(scene.pooled.plane(0)[p], scene.shares.plane(0)[p]);
}

TEST(SharePooling, KeepsReliefThatIsNotMuchMoreThanTheNoise) {
  Scene scene;
  std::mt19937 random(7);
  std::normal_distribution<float> gauss;
  Image truth = scene.shares.clone();
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float a = .5F + 2 * kSigma * gauss(random);
      truth.span().at(0, x, y) = a;
      scene.shares.span().at(0, x, y) = a + kSigma * gauss(random);
      scene.shares.span().at(1, x, y) = 1 - scene.shares.view().at(0, x, y);
    }
  scene.pool();
  double sum = 0;
  for (size_t p = 0; p < truth.pixelCount(); ++p)
    sum += std::pow(scene.pooled.plane(0)[p] - truth.plane(0)[p], 2);
  EXPECT_LT(std::sqrt(sum / double(truth.pixelCount())), kSigma) << "no worse than the pixels on their own";
}

TEST(SharePooling, IsTheSameForLightsInAnotherOrder) {
  Scene scene;
  scene.pool({.step = 2, .rejectChi2 = 4});
  Scene swapped;
  std::copy_n(scene.shares.plane(0), scene.shares.pixelCount(), swapped.shares.plane(1));
  std::copy_n(scene.shares.plane(1), scene.shares.pixelCount(), swapped.shares.plane(0));
  swapped.pool({.step = 2, .rejectChi2 = 4});
  for (size_t p = 0; p < scene.shares.pixelCount(); ++p)
    ASSERT_NEAR(scene.pooled.plane(0)[p], swapped.pooled.plane(1)[p], 1e-5F);
}

TEST(SharePooling, CutSharesAreSharesAgain) {
  Scene scene;
  scene.pool({.clampAtZero = true});
  for (size_t p = 0; p < scene.pooled.pixelCount(); ++p) {
    EXPECT_GE(scene.pooled.plane(0)[p], 0);
    EXPECT_NEAR(scene.pooled.plane(0)[p] + scene.pooled.plane(1)[p], 1, 1e-5F);
  }
}

}  // namespace
}  // namespace swaplight
