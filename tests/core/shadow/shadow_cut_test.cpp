#include "core/shadow/detect/shadow_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/base/json.h"
#include "core/shadow/detect/shadow_regions.h"
#include "core/shadow/detect/shadow_threshold.h"
#include "core/shadow/evidence/shadow_evidence.h"

namespace swaplight {
namespace {

constexpr int kWidth = 480, kHeight = 120;
constexpr int kEnd = 30;  // the column where the first light stops reaching the surface

/// A surface that turns away from a light towards the left, lit by a second one everywhere; beyond the end
/// there is as much bounced light as given.
SetEvidence turningSurface(float bounced) {
  SolvedSet set;
  set.capture.lights = {{"key", Role::Key, Json::object()}, {"fill", Role::Fill, Json::object()}};
  for (int i = 0; i < 2; ++i) set.contributions.emplace_back(ImageSpec::rgb(kWidth, kHeight));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float angle = static_cast<float>(x - kEnd) / 120;
      const float fill = .5F * std::max(.3F, std::cos(angle - 1.F));
      for (int c = 0; c < 3; ++c) {
        set.contributions[0].span().at(c, x, y) = std::max(0.F, std::sin(angle)) + bounced;
        set.contributions[1].span().at(c, x, y) = fill;
      }
    }
  updateBeta(set);
  return gatherShadowEvidence(set);
}

ShadowSides sidesOf(const SetEvidence& evidence) {
  std::vector<float> thresholds;
  for (const ShadowEvidence& light : evidence.lights)
    thresholds.push_back(shadowThreshold(light, evidence.known));
  return shadowSides(evidence, brightParts(evidence, thresholds), 0);
}

TEST(ShadowSides, ASurfaceStopsSeeingALightWhereTheLightStopsFalling) {
  const ShadowSides sides = sidesOf(turningSurface(.05F));
  ASSERT_EQ(sides.toShadow.cols, kWidth);
  float beyond = 0;
  float before = 0;
  for (int x = kEnd - 8; x < kEnd; ++x) beyond += sides.toShadow.at<float>(60, x);
  for (int x = kEnd; x < kEnd + 8; ++x) before += sides.toShadow.at<float>(60, x);
  EXPECT_GT(beyond, 1);
  EXPECT_LT(before, -1);
  for (int x = kEnd + 30; x < kEnd + 150; ++x) EXPECT_EQ(sides.toShadow.at<float>(60, x), 0) << x;
}

TEST(ShadowCut, BouncedLightAboveTheThresholdIsShadowBeyondSuchABend) {
  const SetEvidence evidence = turningSurface(.05F);
  const ShadowSides sides = sidesOf(evidence);
  // Two thirds of the bounced light: the level alone says lit everywhere.
  const float threshold = evidence.lights[0].level.at<float>(60, 10) - .4F;
  const cv::Mat shadow = cutShadow(evidence.lights[0].level, threshold, sides);
  EXPECT_GT(cv::countNonZero(shadow.colRange(0, kEnd - 4)), .95 * kHeight * (kEnd - 4));
  EXPECT_EQ(cv::countNonZero(shadow.colRange(kEnd + 12, kEnd + 200)), 0);
}

TEST(ShadowCut, ReachesThePicturesRim) {
  const SetEvidence evidence = turningSurface(.05F);
  const ShadowEvidence& key = evidence.lights[0];
  const float threshold = key.level.at<float>(60, 10) - .3F;
  const cv::Mat shadow = cutShadow(key.level, threshold, sidesOf(evidence));
  const cv::Mat visibility = visibilityOf(key, shadow, evidence.known, 16);
  for (int x = 0; x < kEnd - 12; ++x) {
    EXPECT_LT(visibility.at<float>(0, x), .1F) << x;
    EXPECT_LT(visibility.at<float>(kHeight - 1, x), .1F) << x;
  }
}

TEST(ShadowCut, WithoutEdgesTheLevelDecides) {
  cv::Mat level(40, 60, CV_32F, cv::Scalar(2));
  level.colRange(0, 30).setTo(-2);
  const cv::Mat nothing(level.size(), CV_32F, cv::Scalar(0));
  const cv::Mat shadow = cutShadow(level, 0, {nothing, nothing});
  EXPECT_EQ(cv::countNonZero(shadow.colRange(0, 30)), 40 * 30);
  EXPECT_EQ(cv::countNonZero(shadow.colRange(30, 60)), 0);
}

TEST(ShadowCut, ADimPartThatNoEdgeDividesGoesWithTheRest) {
  cv::Mat level(40, 60, CV_32F, cv::Scalar(2));
  level(cv::Rect(20, 10, 12, 12)).setTo(-.2);
  cv::Mat apart(level.size(), CV_32F, cv::Scalar(0));
  const cv::Mat none = apart.clone();
  EXPECT_EQ(cv::countNonZero(cutShadow(level, 0, {none, apart})), 0);
  // With an edge around it, it is a shadow.
  cv::rectangle(apart, cv::Rect(19, 9, 14, 14), cv::Scalar(20), 2);
  EXPECT_GT(cv::countNonZero(cutShadow(level, 0, {none, apart})), 60);
}

// A light that falls to a dim half: by the level in shadow, by the odds as given.
ShadowDivision divisionOfDimHalf(float umbra, float lit, float visible, int oddsEnd = 0) {
  const cv::Size size(120, 80);
  cv::Mat level(size, CV_32F, cv::Scalar(2));
  level.colRange(0, 60).setTo(-2);
  LightOdds odds{cv::Mat(size, CV_32F, cv::Scalar(umbra)), cv::Mat(size, CV_32F, cv::Scalar(lit)),
                 cv::Mat(size, CV_32F, cv::Scalar(visible))};
  odds.umbra.colRange(0, oddsEnd).setTo(6);
  odds.lit.colRange(0, oddsEnd).setTo(-6);
  const cv::Mat nothing = cv::Mat::zeros(size, CV_32F);
  return divideShadow(level, 0, {nothing, nothing}, odds);
}

TEST(DivideShadow, OddsSayOfAWholeSurfaceThatItIsLit) {
  const ShadowDivision division = divisionOfDimHalf(-6, 6, 1);
  EXPECT_EQ(cv::countNonZero(division.shadow), 0);
  EXPECT_EQ(cv::countNonZero(division.untold), 0);
}

TEST(DivideShadow, OddsSayOfAWholeSurfaceThatItIsInShadow) {
  const ShadowDivision division = divisionOfDimHalf(4, -6, 0);
  EXPECT_EQ(cv::countNonZero(division.shadow), 120 * 80);
  EXPECT_EQ(cv::countNonZero(division.untold), 0);
}

TEST(DivideShadow, EvenOddsAreNoAnswerUnlessMostOfTheLightIsSeen) {
  EXPECT_EQ(cv::countNonZero(divisionOfDimHalf(-.6F, .5F, .5F).untold), 120 * 80);
  EXPECT_EQ(cv::countNonZero(divisionOfDimHalf(.2F, -.5F, .5F).untold), 120 * 80);
  EXPECT_EQ(cv::countNonZero(divisionOfDimHalf(-.6F, .5F, .95F).untold), 0);
}

TEST(DivideShadow, ToThePixelTheLevelKnowsBetter) {
  const ShadowDivision division = divisionOfDimHalf(-6, 6, 1, 59);
  EXPECT_EQ(cv::countNonZero(division.shadow), 60 * 80);
  EXPECT_EQ(cv::countNonZero(division.untold), 0);
}

TEST(DivideShadow, WithoutOddsItIsTheLevels) {
  cv::Mat level(40, 60, CV_32F, cv::Scalar(2));
  level.colRange(0, 30).setTo(-2);
  const cv::Mat nothing = cv::Mat::zeros(level.size(), CV_32F);
  const ShadowDivision division = divideShadow(level, 0, {nothing, nothing}, {});
  EXPECT_EQ(cv::countNonZero(division.shadow), 30 * 40);
  EXPECT_EQ(cv::countNonZero(division.untold), 0);
}

}  // namespace
}  // namespace swaplight
