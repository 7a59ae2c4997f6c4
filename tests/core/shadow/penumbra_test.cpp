#include "core/shadow/detect/penumbra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

constexpr int kWidth = 480, kHeight = 160;

/// Two lights over a printed surface: `own` and `other` give their light at a column.
template <typename Own, typename Other>
SetEvidence surface(const Own& own, const Other& other) {
  SetEvidence set;
  for (int light = 0; light < 2; ++light) set.contributions.emplace_back(kHeight, kWidth, CV_32FC3);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float print = (x / 12 + y / 12) % 2 ? .5F : .48F;
      set.contributions[0].at<cv::Vec3f>(y, x) = cv::Vec3f::all(print * own(x));
      set.contributions[1].at<cv::Vec3f>(y, x) = cv::Vec3f::all(print * other(x));
    }
  set.known = cv::Mat(kHeight, kWidth, CV_8U, cv::Scalar(255));
  return set;
}

/// 0 left of a column, 1 from it on; the other light's shadow is nowhere.
std::vector<cv::Mat> dividedAt(int column) {
  cv::Mat own(kHeight, kWidth, CV_32F, cv::Scalar(1));
  own.colRange(0, column).setTo(0);
  return {own, cv::Mat(kHeight, kWidth, CV_32F, cv::Scalar(1))};
}

TEST(Penumbra, OfACastShadowIsAsWideAsItIs) {
  const auto truth = [](int x) {
    const float t = std::clamp(static_cast<float>(x - 200) / 50, 0.F, 1.F);
    return t * t * (3 - 2 * t);
  };
  const SetEvidence set = surface([&](int x) { return .8F * truth(x); }, [](int) { return .6F; });
  const cv::Mat found = refineVisibility(set, dividedAt(212), 0).visibility;
  for (int x = 150; x < 300; ++x) {
    const float faintEnd = truth(x) > .9F ? .1F : .04F;  // hardly changes: counts as lit
    EXPECT_NEAR(found.at<float>(80, x), truth(x), faintEnd) << x;
  }
}

TEST(Penumbra, WhereASurfaceTurnsAwayAllOfTheLightArrivesToTheEnd) {
  // A cylinder: the angle to the end of this light grows to the right; the other light stands 60 degrees off.
  const auto angle = [](int x) { return static_cast<float>(x - 240) / 160; };
  const SetEvidence set = surface([&](int x) { return std::max(0.F, std::sin(angle(x))); },
                                  [&](int x) { return std::max(.05F, std::cos(angle(x) - 1.05F)); });
  const cv::Mat found = refineVisibility(set, dividedAt(246), 0).visibility;
  for (int x = 250; x < 460; ++x) EXPECT_GT(found.at<float>(80, x), .9F) << x;
  for (int x = 130; x < 240; ++x) EXPECT_LT(found.at<float>(80, x), .1F) << x;
}

TEST(Penumbra, WhereASurfaceTurnsAwayTheLightIsFollowedToItsEnd) {
  // As above, in noise; the division lost the light too early.
  const auto angle = [](int x) { return static_cast<float>(x - 240) / 160; };
  cv::RNG random(1);
  const SetEvidence set = surface(
      [&](int x) {
        return std::max(0.F, std::max(0.F, std::sin(angle(x))) + static_cast<float>(random.gaussian(.001)));
      },
      [&](int x) { return std::max(.3F, std::cos(angle(x) - 1.05F)); });
  const cv::Mat reached = refineVisibility(set, dividedAt(252), 0).reached;
  for (int x = 244; x < 280; ++x) EXPECT_GT(reached.at<float>(80, x), .9F) << x;
  for (int x = 130; x < 238; ++x) EXPECT_LT(reached.at<float>(80, x), .1F) << x;
}

TEST(Penumbra, WithoutAShadowEverythingIsLit) {
  const SetEvidence set = surface([](int x) { return x < 240 ? .2F : .8F; }, [](int) { return .6F; });
  const cv::Mat found = refineVisibility(set, dividedAt(0), 0).visibility;
  EXPECT_EQ(cv::countNonZero(found < 1), 0);
}

TEST(Penumbra, OfALightAloneStaysAsItWasDivided) {
  SetEvidence set = surface([](int x) { return x < 240 ? .1F : .8F; }, [](int) { return 0.F; });
  set.contributions.pop_back();
  const std::vector<cv::Mat> divided = {dividedAt(240).front()};
  const RefinedVisibility refined = refineVisibility(set, divided, 0);
  EXPECT_EQ(cv::countNonZero(refined.visibility != divided.front()), 0);
  EXPECT_EQ(cv::countNonZero(refined.told), 0);
}

}  // namespace
}  // namespace swaplight
