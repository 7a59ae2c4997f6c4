#include "core/image/shrunk_image.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace swaplight {

Image shrunkImage(const Image& image, int width, int height) {
  ImageSpec spec = image.spec();
  spec.width = std::max(1, width);
  spec.height = std::max(1, height);
  Image small(std::move(spec));
  for (int c = 0; c < image.channelCount(); ++c) {
    const cv::Mat from(image.height(), image.width(), CV_32F, const_cast<float*>(image.plane(c)));
    cv::Mat to(small.height(), small.width(), CV_32F, small.plane(c));
    cv::resize(from, to, to.size(), 0, 0, cv::INTER_AREA);
  }
  return small;
}

}  // namespace swaplight
