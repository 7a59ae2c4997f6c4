#include "core/capture/capture_frame.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/image/shrunk_image.h"

namespace swaplight {

PixelRect cropFromText(const std::string& text) {
  const std::optional<PixelRect> rect = rectFromText(text);
  if (!rect || rect->x < 0 || rect->y < 0 || rect->empty())
    throw InputError("the crop \"{}\" is none: give X,Y,WIDTH,HEIGHT in pixels of the photographs.", text);
  return *rect;
}

double checkedScale(double scale) {
  if (!(scale >= .02 && scale <= 1))
    throw InputError("the scale {} is not to be had: give 0.02 to 1, 0.5 for half the width and height.",
                     scale);
  return scale;
}

Image scaledImage(const Image& image, double scale, float clip) {
  Image small = shrunkImage(image, static_cast<int>(std::lround(scale * image.width())),
                            static_cast<int>(std::lround(scale * image.height())));
  for (int c = 0; std::isfinite(clip) && c < image.channelCount(); ++c) {
    const cv::Mat from(image.height(), image.width(), CV_32F, const_cast<float*>(image.plane(c)));
    cv::Mat to(small.height(), small.width(), CV_32F, small.plane(c));
    cv::Mat saturated, share;
    cv::Mat(from >= clip).convertTo(saturated, CV_32F);
    cv::resize(saturated, share, to.size(), 0, 0, cv::INTER_AREA);
    cv::Mat(cv::max(to, clip)).copyTo(to, share > 0);
  }
  return small;
}

}  // namespace swaplight
