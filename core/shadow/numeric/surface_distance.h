#pragma once

#include <opencv2/core.hpp>

namespace swaplight {

/// How far every pixel is from one on the way that costs least (float; `most` where it is that far or
/// farther): a geodesic distance, as in Criminisi, Sharp and Blake, "GeoS: geodesic image segmentation",
/// ECCV 2008. A step to one of the eight neighbours costs its length times the mean of `cost` (float, >= 0)
/// at its ends.
[[nodiscard]] cv::Mat surfaceDistance(const cv::Mat& cost, cv::Point from, float most);

}  // namespace swaplight
