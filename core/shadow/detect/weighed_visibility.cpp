#include "core/shadow/detect/weighed_visibility.h"

#include <opencv2/imgproc.hpp>

#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

// A mask of the odds at the size of the picture: where that is larger, without what lies beside its border.
cv::Mat surely(cv::Mat mask, cv::Size full) {
  if (mask.size() == full) return mask;
  cv::erode(mask, mask, {}, {-1, -1}, 1, cv::BORDER_CONSTANT, cv::Scalar(255));
  cv::resize(mask, mask, full, 0, 0, cv::INTER_NEAREST);
  return mask;
}

}  // namespace

cv::Mat weighedVisibility(const cv::Mat& measured, const cv::Mat& told, const LightOdds& odds,
                          const ShadowRegionsTuning& tuning) {
  if (odds.umbra.empty()) return measured;
  const cv::Size full = measured.size();
  const cv::Mat umbra = odds.umbra > tuning.umbraOdds;
  const cv::Mat lit = odds.lit > tuning.litOdds & ~umbra;
  const cv::Mat seen = grown(odds.visible, full);
  const cv::Mat partly = seen + tuning.measured * told.mul(measured - seen);
  cv::Mat weighed = measured.clone();
  partly.copyTo(weighed, surely(~(umbra | lit), full));
  weighed.setTo(0, surely(umbra, full));
  weighed.setTo(1, surely(lit, full));
  return weighed;
}

}  // namespace swaplight
