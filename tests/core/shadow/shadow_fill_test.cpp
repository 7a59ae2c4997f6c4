#include "core/shadow/detect/shadow_fill.h"

#include <gtest/gtest.h>

#include "core/shadow/evidence/other_lights.h"

namespace swaplight {
namespace {

constexpr int kWidth = 480, kHeight = 120;
constexpr int kShadow = 240;  // columns from here on are in the key's shadow

cv::Mat grey(float value) {
  return {kHeight, kWidth, CV_32FC3, cv::Scalar::all(value)};
}
cv::Mat everywhere(float value) {
  return {kHeight, kWidth, CV_32F, cv::Scalar(value)};
}

/// A print under a key that is hidden on the right, an even fill, and a back light that reaches what the key
/// does not, and there is four times as bright as the key.
struct Portrait {
  SetEvidence set;
  std::vector<cv::Mat> visibilities{everywhere(1), everywhere(1), everywhere(0)};
};

Portrait portrait() {
  Portrait made;
  made.set.contributions = {grey(.4F), grey(.2F), grey(0)};
  made.set.contributions[0].colRange(kShadow, kWidth) = cv::Scalar::all(0);
  made.visibilities[0].colRange(kShadow, kWidth) = 0;
  made.set.contributions[2].colRange(kShadow + 10, kWidth) = cv::Scalar::all(1.6);
  made.visibilities[2].colRange(kShadow + 10, kWidth) = 1;
  for (cv::Mat& light : made.set.contributions)
    for (int x = 0; x < kWidth; x += 24) light.colRange(x, x + 12) *= .7;
  made.set.known = cv::Mat(kHeight, kWidth, CV_8U, cv::Scalar(255));
  return made;
}

TEST(ShadowFill, CountsNoLightThatDoesNotShineAround) {
  const Portrait made = portrait();
  cv::Mat lit = everywhere(0);
  lit.colRange(0, kShadow - 5) = 1;
  const cv::Mat around = lightsAround(made.set, made.visibilities, 0, lit);
  for (int x = 20; x < kShadow + 40; ++x) {
    const float fill = x / 12 % 2 ? .2F : .14F;
    EXPECT_NEAR(around.at<cv::Vec3f>(60, x)[1], fill, .1F * fill) << x;
  }
}

TEST(ShadowFill, FillsAsIfABackLightWereNotThere) {
  const Portrait made = portrait();
  const cv::Mat told = everywhere(0);
  const FilledShadow filled = fillShadow(made.set, made.visibilities, told, 0);
  for (int x = kShadow + 15; x < kShadow + 40; ++x) {
    const float key = x / 12 % 2 ? .4F : .28F;
    EXPECT_NEAR(filled.direct.at<cv::Vec3f>(60, x)[1], key, .2F * key) << x;
  }
}

TEST(ShadowFill, OfTwoLightsTakesTheOtherOneAsItIs) {
  Portrait made = portrait();
  made.set.contributions.pop_back();
  made.visibilities.pop_back();
  const FilledShadow filled = fillShadow(made.set, made.visibilities, everywhere(0), 0);
  for (int x = kShadow + 15; x < kShadow + 60; ++x) {
    const float key = x / 12 % 2 ? .4F : .28F;
    EXPECT_NEAR(filled.direct.at<cv::Vec3f>(60, x)[1], key, .05F * key) << x;
  }
}

}  // namespace
}  // namespace swaplight
