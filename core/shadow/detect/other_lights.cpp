#include "core/shadow/detect/other_lights.h"

#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {

OtherLights otherLights(const SetEvidence& set, const std::vector<cv::Mat>& visibilities, size_t light,
                        int rim, const OtherLightsTuning& tuning) {
  const cv::Size size = set.contributions[light].size();
  OtherLights others{cv::Mat(size, CV_32FC3, cv::Scalar::all(0)), {}, {}};
  cv::Mat seen(size, CV_32F, cv::Scalar(0));
  for (size_t j = 0; j < set.contributions.size(); ++j) {
    if (j == light) continue;
    others.rgb += set.contributions[j];
    seen = cv::max(seen, visibilities[j]);
  }
  others.grey = greyOf(others.rgb);
  cv::Mat reached = seen > tuning.seen;
  cv::erode(reached, reached, {}, {-1, -1}, rim, cv::BORDER_CONSTANT, cv::Scalar(255));
  others.known = (others.grey > tuning.dark) & reached;
  return others;
}

cv::Mat OtherLights::ratioOf(const cv::Mat& own, const cv::Mat& mask, cv::Size size) const {
  cv::Mat ratio;
  cv::divide(shrunk(own.mul(mask), size), cv::max(shrunk(grey.mul(mask), size), 1e-6), ratio);
  return ratio;
}

}  // namespace swaplight
