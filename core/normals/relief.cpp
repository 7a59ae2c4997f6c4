#include "core/normals/relief.h"

#include <algorithm>

#include "core/shadow/numeric/gradient_integration.h"

namespace swaplight {
namespace {

constexpr float kSteepest = 3;

/// The mean slope of two neighbours along an axis.
float slopeBetween(const Image& normals, int axis, size_t a, size_t b) {
  const auto slope = [&](size_t pixel) {
    const float z = normals.plane(2)[pixel];
    if (z <= 0) return 0.F;
    return std::clamp(normals.plane(axis)[pixel] / z, -kSteepest, kSteepest);
  };
  return (slope(a) + slope(b)) / 2;
}

}  // namespace

Image reliefOf(const Image& normals) {
  const int width = normals.width();
  const int height = normals.height();
  cv::Mat gx(height, width, CV_32F, cv::Scalar(0));
  cv::Mat gy(height, width, CV_32F, cv::Scalar(0));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto row = static_cast<size_t>(width);
      const size_t pixel = static_cast<size_t>(y) * row + static_cast<size_t>(x);
      // Depth grows away from the camera, rows go down: the two turn the signs of x and y apart.
      if (x + 1 < width) gx.at<float>(y, x) = slopeBetween(normals, 0, pixel, pixel + 1);
      if (y + 1 < height) gy.at<float>(y, x) = -slopeBetween(normals, 1, pixel, pixel + row);
    }
  const cv::Mat pixels = integrateGradients(gx, gy);
  Image depth(ImageSpec{width, height, {"depth.Z"}, "data"});
  for (int y = 0; y < height; ++y)
    std::transform(pixels.ptr<float>(y), pixels.ptr<float>(y) + width, depth.span().row(0, y),
                   [&](float pixel) { return pixel / static_cast<float>(width); });
  return depth;
}

}  // namespace swaplight
