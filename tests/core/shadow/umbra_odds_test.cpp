#include "core/shadow/odds/umbra_odds.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace swaplight {
namespace {

constexpr int kWidth = 240, kHeight = 160;

// A printed floor that two lights fall upon, the first from one side, with a hard shadow; bounced light in
// it.
std::vector<cv::Mat> shadowedFloor(float key = 1, float fill = .4F) {
  std::vector<cv::Mat> lights(2);
  for (cv::Mat& light : lights) light.create(kHeight, kWidth, CV_32FC3);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float albedo = (x / 20 + y / 20) % 2 ? .6F : .3F;
      const bool shadow = x > 90 && x < 150 && y > 50 && y < 110;
      const float given = .5F + .5F * static_cast<float>(x) / kWidth;
      lights[0].at<cv::Vec3f>(y, x) = cv::Vec3f::all(key * albedo * ((shadow ? 0 : given) + .02F));
      lights[1].at<cv::Vec3f>(y, x) = cv::Vec3f::all(fill * albedo);
    }
  return lights;
}

TEST(UmbraFeatures, HaveANameEach) {
  const SmallSet set = smallSetOf(shadowedFloor(), {kWidth, kHeight});
  EXPECT_EQ(umbraFeatures(set, 0).size(), umbraFeatureNames().size());
}

TEST(UmbraFeatures, AreFiniteForBlackPixelsAndASingleLight) {
  std::vector<cv::Mat> lights = shadowedFloor();
  lights.pop_back();
  lights[0](cv::Rect(0, 0, 80, 80)).setTo(0);
  for (const cv::Mat& feature : umbraFeatures(smallSetOf(lights, {kWidth, kHeight}), 0))
    EXPECT_TRUE(cv::checkRange(feature));
}

TEST(UmbraOdds, SpeakForAHardShadowAndAgainstWhatIsLit) {
  const LightOdds odds = umbraOdds(smallSetOf(shadowedFloor(), {kWidth, kHeight}), 0);
  EXPECT_GT(cv::mean(odds.umbra(cv::Rect(100, 60, 40, 40)))[0], 1);
  EXPECT_LT(cv::mean(odds.umbra(cv::Rect(10, 10, 60, 140)))[0], -2);
  EXPECT_GT(cv::mean(odds.lit(cv::Rect(10, 10, 60, 140)))[0], 1);
}

TEST(UmbraOdds, DoNotHangOnHowStrongTheLightsAre) {
  const cv::Rect shadow(100, 60, 40, 40);
  const LightOdds even = umbraOdds(smallSetOf(shadowedFloor(), {kWidth, kHeight}), 0);
  const LightOdds weak = umbraOdds(smallSetOf(shadowedFloor(.3F, .9F), {kWidth, kHeight}), 0);
  EXPECT_GT(cv::mean(weak.umbra(shadow))[0], 1);
  EXPECT_NEAR(cv::mean(weak.umbra)[0], cv::mean(even.umbra)[0], .7);
}

TEST(UmbraOdds, OfEvenLightAreNone) {
  const std::vector<cv::Mat> lights(2, cv::Mat(kHeight, kWidth, CV_32FC3, cv::Scalar::all(.4)));
  EXPECT_TRUE(umbraOdds(smallSetOf(lights, {kWidth, kHeight}), 0).umbra.empty());
}

}  // namespace
}  // namespace swaplight
