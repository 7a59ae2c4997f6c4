#include "core/shadow/odds/umbra_odds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace swaplight {
namespace {

constexpr int kWidth = 240, kHeight = 160;

// A printed floor that two lights fall upon, the first from one side, with a hard shadow; bounced light in
// it.
std::vector<Image> shadowedFloor(float key = 1, float fill = .4F) {
  std::vector<Image> lights;
  for (int i = 0; i < 2; ++i) lights.emplace_back(ImageSpec::rgb(kWidth, kHeight));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float albedo = (x / 20 + y / 20) % 2 ? .6F : .3F;
      const bool shadow = x > 90 && x < 150 && y > 50 && y < 110;
      const float given = .5F + .5F * static_cast<float>(x) / kWidth;
      for (int c = 0; c < 3; ++c) {
        lights[0].span().at(c, x, y) = key * albedo * ((shadow ? 0 : given) + .02F);
        lights[1].span().at(c, x, y) = fill * albedo;
      }
    }
  return lights;
}

TEST(UmbraEvidence, IsAsManyPicturesAsTheNetworkTakes) {
  const SmallSet set = smallSetOf(shadowedFloor(), {kWidth, kHeight});
  EXPECT_EQ(umbraEvidence(set, 0).size(), size_t(kUmbraEvidence));
}

TEST(UmbraEvidence, IsFiniteForBlackPixelsAndASingleLight) {
  std::vector<Image> lights = shadowedFloor();
  lights.pop_back();
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 80; ++x) lights[0].span().at(0, x, y) = 0;
  for (const cv::Mat& picture : umbraEvidence(smallSetOf(lights, {kWidth, kHeight}), 0))
    EXPECT_TRUE(cv::checkRange(picture));
}

TEST(UmbraEvidence, IsTheSameForStrongerLights) {
  const std::vector<cv::Mat> one = umbraEvidence(smallSetOf(shadowedFloor(), {kWidth, kHeight}), 0);
  const std::vector<cv::Mat> other = umbraEvidence(smallSetOf(shadowedFloor(50, 20), {kWidth, kHeight}), 0);
  for (size_t i = 0; i < one.size(); ++i) EXPECT_LT(cv::norm(one[i], other[i], cv::NORM_INF), 1e-3) << i;
}

TEST(UmbraOdds, DoNotAskHowTheOtherLightsAreOrdered) {
  std::vector<Image> lights = shadowedFloor();
  lights.push_back(Image(ImageSpec::rgb(kWidth, kHeight)));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c) lights[2].span().at(c, x, y) = x < 60 ? .01F : .2F;
  const LightOdds one = UmbraOdds(smallSetOf(lights, {kWidth, kHeight})).of(0);
  std::swap(lights[1], lights[2]);
  const LightOdds other = UmbraOdds(smallSetOf(lights, {kWidth, kHeight})).of(0);
  EXPECT_LT(cv::norm(one.umbra, other.umbra, cv::NORM_INF), 1e-2);
}

TEST(UmbraOdds, AreOfAnySize) {
  for (const cv::Size size : {cv::Size(9, 31), cv::Size(33, 8), cv::Size(100, 64)})
    EXPECT_EQ(UmbraOdds(smallSetOf(shadowedFloor(), size)).of(0).visible.size(), size);
}

TEST(UmbraOdds, SpeakForAHardShadowAndAgainstWhatIsLit) {
  const LightOdds odds = UmbraOdds(smallSetOf(shadowedFloor(), {kWidth, kHeight})).of(0);
  EXPECT_GT(cv::mean(odds.umbra(cv::Rect(100, 60, 40, 40)))[0], 1);
  EXPECT_LT(cv::mean(odds.umbra(cv::Rect(10, 10, 60, 140)))[0], -2);
  EXPECT_GT(cv::mean(odds.lit(cv::Rect(10, 10, 60, 140)))[0], 1);
}

TEST(UmbraOdds, DoNotHangOnHowStrongTheLightsAre) {
  const cv::Rect shadow(100, 60, 40, 40);
  const LightOdds even = UmbraOdds(smallSetOf(shadowedFloor(), {kWidth, kHeight})).of(0);
  const LightOdds weak = UmbraOdds(smallSetOf(shadowedFloor(.3F, .9F), {kWidth, kHeight})).of(0);
  EXPECT_GT(cv::mean(weak.umbra(shadow))[0], 1);
  EXPECT_NEAR(cv::mean(weak.umbra)[0], cv::mean(even.umbra)[0], .7);
}

TEST(UmbraOdds, OfEvenLightAreNone) {
  std::vector<Image> lights;
  for (int i = 0; i < 2; ++i) {
    lights.emplace_back(ImageSpec::rgb(kWidth, kHeight));
    for (int c = 0; c < 3; ++c) std::fill_n(lights.back().plane(c), lights.back().pixelCount(), .4F);
  }
  EXPECT_TRUE(UmbraOdds(smallSetOf(lights, {kWidth, kHeight})).of(0).umbra.empty());
}

}  // namespace
}  // namespace swaplight
