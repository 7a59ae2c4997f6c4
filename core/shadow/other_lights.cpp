#include "core/shadow/other_lights.h"

#include <algorithm>

#include "core/shadow/shadow_pictures.h"

namespace swaplight {
namespace {

constexpr int kLargestWork = 640;
constexpr float kDark = .004f;  // of white: where the other lights say nothing of the surface
constexpr float kSeen = .7f;    // visibility from which on a light shows a surface well enough
constexpr float kGuideFloor = .01f;

}  // namespace

OtherLights otherLights(const SetEvidence& set, const std::vector<cv::Mat>& visibilities, size_t light,
                        int rim) {
  const cv::Size size = set.contributions[light].size();
  OtherLights others{cv::Mat(size, CV_32FC3, cv::Scalar::all(0)), {}, {}};
  cv::Mat seen(size, CV_32F, cv::Scalar(0));
  for (size_t j = 0; j < set.contributions.size(); ++j) {
    if (j == light) continue;
    others.rgb += set.contributions[j];
    seen = cv::max(seen, visibilities[j]);
  }
  others.grey = greyOf(others.rgb);
  cv::Mat reached = seen > kSeen;
  cv::erode(reached, reached, {}, {-1, -1}, rim, cv::BORDER_CONSTANT, cv::Scalar(255));
  others.known = (others.grey > kDark) & reached;
  return others;
}

cv::Size workingSize(cv::Size full) {
  const int shrink = (std::max(full.width, full.height) + kLargestWork - 1) / kLargestWork;
  return {(full.width + shrink - 1) / shrink, (full.height + shrink - 1) / shrink};
}

cv::Mat guideOf(const cv::Mat& rgb) {
  cv::Mat guide = rgb + cv::Scalar::all(kGuideFloor);
  cv::log(guide, guide);
  return guide;
}

}  // namespace swaplight
