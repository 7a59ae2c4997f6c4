#pragma once

#include <opencv2/imgproc.hpp>

#include "core/image/image.h"

namespace swaplight {

/// A channel of a picture at a smaller size: the mean of what falls into each pixel.
inline cv::Mat shrunkPlane(const Image& image, int channel, cv::Size size) {
  const cv::Mat plane(image.height(), image.width(), CV_32F, const_cast<float*>(image.plane(channel)));
  cv::Mat small;
  cv::resize(plane, small, size, 0, 0, cv::INTER_AREA);
  return small;
}

}  // namespace swaplight
