#include "core/shadow/detect/weighed_visibility.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

constexpr int kNarrow = 5;  // pixels: a strip less wide is a border or a print's outline, no penumbra
constexpr int kBorder = 4;  // pixels of the odds, half of which are of a picture half as large

// A mask of the odds at the size of the picture, without what lies within so many of their pixels of its
// border.
cv::Mat inside(const cv::Mat& mask, int border, cv::Size full) {
  cv::Mat out;
  cv::erode(mask, out, {}, {-1, -1}, border, cv::BORDER_CONSTANT, cv::Scalar(255));
  cv::resize(out, out, full, 0, 0, cv::INTER_NEAREST);
  return out;
}

}  // namespace

cv::Mat weighedVisibility(const cv::Mat& measured, const cv::Mat& told, const LightOdds& odds,
                          const ShadowRegionsTuning& tuning) {
  if (odds.umbra.empty()) return measured;
  const cv::Size full = measured.size();
  const cv::Mat umbra = odds.umbra > tuning.umbraOdds;
  const cv::Mat lit = (odds.lit > tuning.litOdds) & ~umbra;
  const cv::Mat seen = grown(odds.visible, full);
  const cv::Mat well = told.mul(told).mul(told);  // half told is hardly better than the odds
  const cv::Mat partly = seen + well.mul(measured - seen);
  cv::Mat weighed = measured.clone();
  cv::Mat between = ~(umbra | lit);
  cv::morphologyEx(between, between, cv::MORPH_OPEN, cv::Mat::ones(kNarrow, kNarrow, CV_8U));
  partly.copyTo(weighed, inside(between, 0, full));
  const int border = umbra.size() == full ? 0 : kBorder;
  cv::Mat(cv::max(weighed, tuning.umbra)).copyTo(weighed, inside(odds.umbra < 0, border, full));
  weighed.setTo(0, inside(umbra, border, full));
  weighed.setTo(1, inside(lit, std::max(border, 1), full));
  return weighed;
}

}  // namespace swaplight
