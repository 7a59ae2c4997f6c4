#include "core/shadow/result/connected_shadow.h"

#include <opencv2/imgproc.hpp>

#include "core/shadow/result/label_mask.h"

namespace swaplight {

std::optional<ConnectedShadow> connectedShadowAt(const LightShadows& shadows, int x, int y) {
  const cv::Mat regions = shadowRegions(shadows);
  const bool inside = x >= 0 && y >= 0 && x < regions.cols && y < regions.rows;
  const int region = inside ? regions.at<int>(y, x) : 0;
  if (region == 0) return std::nullopt;

  const cv::Mat mask = regions == region;
  const cv::Rect box = cv::boundingRect(mask);
  cv::Mat part;
  cv::copyMakeBorder(mask(box), part, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::Mat depth;
  cv::distanceTransform(part, depth, cv::DIST_L2, cv::DIST_MASK_5);
  cv::Point deepest;
  cv::minMaxLoc(depth, nullptr, nullptr, nullptr, &deepest);
  return ConnectedShadow{box.x + deepest.x - 1, box.y + deepest.y - 1,
                         static_cast<size_t>(cv::countNonZero(mask)), outlinesOfMask(mask, 1, .6f)};
}

}  // namespace swaplight
