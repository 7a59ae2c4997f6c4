#include "core/shadow/detect/shadow_threshold.h"

#include <gtest/gtest.h>

namespace swaplight {
namespace {

constexpr int kWidth = 240, kHeight = 135;
constexpr float kWall = .08F, kShadow = .04F;

bool onWall(int x) {
  return x >= kWidth / 2;
}

bool inShadow(int x, int y) {
  return x >= 170 && x < 190 && y >= 50 && y < 80;
}

/// A bright table before a far wall that the key lights dimly, with a shadow on it; the fill lights all.
SetEvidence farWall() {
  SolvedSet set;
  set.capture.lights = {{"key", Role::Key, Json::object()}, {"fill", Role::Fill, Json::object()}};
  for (int i = 0; i < 2; ++i) set.contributions.emplace_back(ImageSpec::rgb(kWidth, kHeight));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c) {
        set.contributions[0].span().at(c, x, y) = inShadow(x, y) ? kShadow : onWall(x) ? kWall : 1;
        set.contributions[1].span().at(c, x, y) = .5F;
      }
  updateBeta(set);
  return gatherShadowEvidence(set);
}

/// Log-odds of light: surely lit but for the wall, of which they say `wall`, and for its shadow.
cv::Mat oddsOf(float wall, int factor) {
  cv::Mat odds(kHeight / factor, kWidth / factor, CV_32F);
  for (int y = 0; y < odds.rows; ++y)
    for (int x = 0; x < odds.cols; ++x)
      odds.at<float>(y, x) = inShadow(factor * x, factor * y) ? -3.F : onWall(factor * x) ? wall : 3.F;
  return odds;
}

constexpr int kWallX = 230, kWallY = 20, kShadowX = 180, kShadowY = 65;

bool below(const SetEvidence& evidence, const cv::Mat& odds, int x, int y) {
  const ShadowEvidence& key = evidence.lights[0];
  return key.level.at<float>(y, x) < shadowThreshold(key, evidence.known, odds);
}

TEST(ShadowThreshold, LeavesNoFarWallInShadowThatTheOddsCallLit) {
  const SetEvidence evidence = farWall();
  EXPECT_TRUE(below(evidence, {}, kWallX, kWallY)) << "its outline is longer than that of the shadow on it";
  for (const int factor : {1, 3}) {
    EXPECT_FALSE(below(evidence, oddsOf(2, factor), kWallX, kWallY)) << factor;
    EXPECT_TRUE(below(evidence, oddsOf(2, factor), kShadowX, kShadowY)) << factor;
  }
}

TEST(ShadowThreshold, TakesInWhatTheOddsCallShadow) {
  const SetEvidence evidence = farWall();
  const ShadowEvidence& key = evidence.lights[0];
  ShadowThresholdTuning tuning;
  tuning.usualLevel = .03;  // as dark as the shadow on the wall, and not as the wall
  tuning.spreadAbove = .3;
  const float level = key.level.at<float>(kWallY, kWallX);
  EXPECT_GT(level, shadowThreshold(key, evidence.known, {}, tuning));
  EXPECT_GT(level, shadowThreshold(key, evidence.known, oddsOf(2, 1), tuning));
  tuning.oddsWeight = 40;  // they speak softly
  EXPECT_LT(level, shadowThreshold(key, evidence.known, oddsOf(-3, 1), tuning));
}

}  // namespace
}  // namespace swaplight
