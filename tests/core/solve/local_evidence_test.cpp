#include "core/solve/auto/local_evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/solve/solve.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

constexpr SensorNoise kNoise{.0005, 100000};
constexpr int kLeft = 40, kRight = 88, kTop = 16, kBottom = 48;  ///< where the set is not matte
constexpr int kReach = 4;                                        ///< of the windows

bool inside(int x, int y, int margin = 0) {
  return x >= kLeft - margin && x < kRight + margin && y >= kTop - margin && y < kBottom + margin;
}

/// A matte set, but for a block in which the first light is redder than its share says.
SyntheticSet notMatteInTheMiddle(int lights, float more = 1.5F) {
  SyntheticSet set(lights, 0);
  for (int y = 0; y < set.height; ++y)
    for (int x = 0; x < set.width; ++x)
      if (inside(x, y)) set.truth[0].span().at(0, x, y) *= more;
  return set;
}

struct Followed {
  SyntheticSet truth;
  Capture capture;
  CapturePixels pixels;
  SolvedSet before, after;

  Followed(SyntheticSet set, const Capture& of, float colorUncertainty = 0, bool broken = false)
      : truth(std::move(set)), capture(of) {
    capture.noise = kNoise;
    pixels = photograph(capture, truth);
    if (broken) pixels.shots[0].span().at(0, 60, 30) = NAN;
    SolveOptions options;
    options.model = Model::Lambert;
    before = solve(capture, pixels, options);
    after = solve(capture, pixels, options);
    const EstimatorContext context{lightingFromCapture(capture), noiseModel(kNoise, pixels, 0)};
    const ShotSignal signal(pixels, context.lighting, context.noise,
                            std::vector<float>(capture.shots.size(), 1.0F));
    followLocalEvidence(context, colorUncertainty, signal, {}, after);
  }

  /// RMS error of all contributions in the block.
  [[nodiscard]] double error(const SolvedSet& set) const {
    double sum = 0;
    int count = 0;
    for (size_t i = 0; i < truth.truth.size(); ++i)
      for (int c = 0; c < 3; ++c)
        for (int y = kTop; y < kBottom; ++y)
          for (int x = kLeft; x < kRight; ++x, ++count)
            sum += std::pow(set.contributions[i].view().at(c, x, y) - truth.truth[i].view().at(c, x, y), 2);
    return std::sqrt(sum / count);
  }
  /// Pixels of the light and channel that have changed at all.
  [[nodiscard]] int changed(size_t light, int channel, int margin) const {
    int count = 0;
    for (int y = 0; y < truth.height; ++y)
      for (int x = 0; x < truth.width; ++x)
        count += !inside(x, y, margin) && before.contributions[light].view().at(channel, x, y) !=
                                              after.contributions[light].view().at(channel, x, y);
    return count;
  }
};

constexpr int kEverywhere = -1000;

TEST(LocalEvidence, GoesToWhatThePhotographsSurelyShow) {
  for (const int lights : {2, 3}) {
    const Followed one(notMatteInTheMiddle(lights), rotatedCapture(lights));
    EXPECT_LT(one.error(one.after), .35 * one.error(one.before)) << lights;
    EXPECT_GT(one.changed(0, 0, kEverywhere), (kRight - kLeft) * (kBottom - kTop) / 2);
    // Beyond it only chance moves, by less than noise.
    double far = 0;
    for (int x = 0; x < one.truth.width; ++x)
      far = std::max(far, std::abs(double(one.after.contributions[0].view().at(0, x, 2)) -
                                   double(one.before.contributions[0].view().at(0, x, 2))));
    EXPECT_LT(far, .01);
  }
}

TEST(LocalEvidence, SharesAreSharesAndNothingIsNegative) {
  const Followed one(notMatteInTheMiddle(3), rotatedCapture(3));
  for (size_t p = 0; p < one.truth.truth[0].pixelCount(); ++p) {
    float sum = 0;
    for (int i = 0; i < 3; ++i) {
      sum += one.after.beta.plane(i)[p];
      for (int c = 0; c < 3; ++c) ASSERT_GE(one.after.contributions[size_t(i)].plane(c)[p], 0);
    }
    ASSERT_NEAR(sum, 1, 1e-4);
    ASSERT_GE(one.after.quality.plane(kSigma)[p], one.before.quality.plane(kSigma)[p]);
    ASSERT_GE(one.after.quality.plane(kModel)[p], one.before.quality.plane(kModel)[p]);
  }
}

TEST(LocalEvidence, DoesNotFollowNoise) {
  const Followed one(SyntheticSet(3, 0), rotatedCapture(3));
  for (size_t i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c) EXPECT_EQ(one.changed(i, c, kEverywhere), 0) << i << c;
}

TEST(LocalEvidence, IsNoneWhereTheColorsMayBeAsWrong) {
  const Followed one(notMatteInTheMiddle(2, 1.1F), rotatedCapture(2), .3F);
  EXPECT_EQ(one.changed(0, 0, kEverywhere), 0);
  const Followed sure(notMatteInTheMiddle(2, 1.1F), rotatedCapture(2), 0);
  EXPECT_GT(sure.changed(0, 0, kEverywhere), 0);
}

TEST(LocalEvidence, IsNoneWhereAChannelHardlyTellsTheLightsApart) {
  std::vector<Rgb> colors = {{.9F, .2F, .5F}, {.15F, .8F, .46F}};  // blue tells them apart by 4 %
  SyntheticSet set = notMatteInTheMiddle(2);
  for (int y = kTop; y < kBottom; ++y)
    for (int x = kLeft; x < kRight; ++x) set.truth[0].span().at(2, x, y) *= 1.5F;
  const Followed one(std::move(set), rotatedCapture(2, colors));
  for (int c = 0; c < 3; ++c)
    EXPECT_EQ(one.changed(0, c, kEverywhere), 0) << "one channel alone would change its hue";
}

TEST(LocalEvidence, LeavesPixelsThatAreBroken) {
  const Followed one(notMatteInTheMiddle(2), rotatedCapture(2), 0, true);
  for (size_t i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(one.after.contributions[i].view().at(c, 60, 30),
                one.before.contributions[i].view().at(c, 60, 30));
  EXPECT_NE(one.after.contributions[0].view().at(0, 61, 30),
            one.before.contributions[0].view().at(0, 61, 30));
}

TEST(LocalEvidence, ABrokenPixelIsNoEvidenceOfOthers) {
  SyntheticSet set(3, 0);
  set.truth[0].span().at(0, 64, 32) += 40;
  const Followed one(std::move(set), rotatedCapture(3));
  for (size_t i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c) EXPECT_EQ(one.changed(i, c, kEverywhere), 0) << i << c;
}

TEST(LocalEvidence, AnAmbientPictureThatIsBrokenSpoilsNothing) {
  SolveOptions options;
  Capture capture = rotatedCapture(2);
  capture.noise = kNoise;
  const SyntheticSet truth = notMatteInTheMiddle(2);
  CapturePixels pixels = photograph(capture, truth);
  pixels.ambient.emplace(ImageSpec::rgb(truth.width, truth.height), 0.01F);
  for (Image& shot : pixels.shots)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < shot.pixelCount(); ++p) shot.plane(c)[p] += 0.01F;
  pixels.ambient->span().at(0, 60, 30) = NAN;
  const SolvedSet set = solve(capture, pixels, options);
  for (size_t i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < set.quality.pixelCount(); ++p)
        ASSERT_TRUE(std::isfinite(set.contributions[i].plane(c)[p])) << p;
}

}  // namespace
}  // namespace swaplight
