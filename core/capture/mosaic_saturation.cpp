#include "core/capture/mosaic_saturation.h"

#include <opencv2/imgproc.hpp>

namespace swaplight {

void spreadSaturation(Image& image, float clip) {
  for (int c = 0; c < image.channelCount(); ++c) {
    cv::Mat plane(image.height(), image.width(), CV_32F, image.plane(c));
    cv::Mat largest;
    cv::dilate(plane, largest, {});  // of 3 x 3: every colour's filters lie no further apart
    plane.setTo(1.F, largest >= clip);
  }
}

}  // namespace swaplight
