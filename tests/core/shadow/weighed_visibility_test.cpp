#include "core/shadow/detect/weighed_visibility.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace swaplight {
namespace {

// Umbra in the left third, penumbra (a quarter of the light seen) in the middle, lit on the right.
LightOdds oddsInThirds(cv::Size size) {
  LightOdds odds{cv::Mat(size, CV_32F, cv::Scalar(-6)), cv::Mat(size, CV_32F, cv::Scalar(-6)),
                 cv::Mat(size, CV_32F, cv::Scalar(.25))};
  odds.umbra.colRange(0, size.width / 3).setTo(6);
  odds.lit.colRange(2 * size.width / 3, size.width).setTo(6);
  return odds;
}

const cv::Mat kMeasured(60, 90, CV_32F, cv::Scalar(.5));

TEST(WeighedVisibility, IsWhatTheOddsSayWhereNothingWasTold) {
  const cv::Mat weighed =
      weighedVisibility(kMeasured, cv::Mat::zeros(60, 90, CV_32F), oddsInThirds({90, 60}));
  EXPECT_EQ(weighed.at<float>(30, 10), 0);
  EXPECT_FLOAT_EQ(weighed.at<float>(30, 45), .25F);
  EXPECT_EQ(weighed.at<float>(30, 80), 1);
}

TEST(WeighedVisibility, HeedsAPenumbraAsFarAsItWasMeasuredWell) {
  const auto told = [](double share) {
    const cv::Mat well(60, 90, CV_32F, cv::Scalar(share));
    const cv::Mat weighed = weighedVisibility(kMeasured, well, oddsInThirds({90, 60}));
    EXPECT_EQ(weighed.at<float>(30, 10), 0);
    return weighed.at<float>(30, 45);
  };
  EXPECT_FLOAT_EQ(told(1), .5F);
  EXPECT_LT(told(.5), .3F);
}

TEST(WeighedVisibility, TakesAPrintsOutlineForNoPenumbra) {
  LightOdds odds = oddsInThirds({90, 60});
  odds.lit.col(75).setTo(-6);
  const cv::Mat measured = cv::Mat::ones(60, 90, CV_32F);
  EXPECT_EQ(weighedVisibility(measured, cv::Mat::zeros(60, 90, CV_32F), odds).at<float>(30, 75), 1);
}

TEST(WeighedVisibility, LeavesBordersThatSmallerOddsCannotKnow) {
  const cv::Mat weighed = weighedVisibility(kMeasured, cv::Mat::ones(60, 90, CV_32F), oddsInThirds({30, 20}));
  EXPECT_EQ(weighed.at<float>(30, 10), 0);
  EXPECT_EQ(weighed.at<float>(30, 29), .5F);
  EXPECT_EQ(weighed.at<float>(30, 31), .5F);
  EXPECT_EQ(weighed.at<float>(30, 80), 1);
}

TEST(WeighedVisibility, WithoutOddsIsWhatWasMeasured) {
  const cv::Mat weighed = weighedVisibility(kMeasured, cv::Mat::ones(60, 90, CV_32F), {});
  EXPECT_EQ(cv::norm(weighed, kMeasured, cv::NORM_INF), 0);
}

}  // namespace
}  // namespace swaplight
