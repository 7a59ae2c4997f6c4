#include "core/plot/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace swaplight {
namespace {

std::array<Rgb, 256> makeTable() {
  cv::Mat ramp(1, 256, CV_8UC1);
  for (int i = 0; i < 256; ++i) ramp.at<uchar>(i) = static_cast<uchar>(i);
  cv::Mat colors;  // blue, green, red
  cv::applyColorMap(ramp, colors, cv::COLORMAP_VIRIDIS);
  std::array<Rgb, 256> table;
  for (int i = 0; i < 256; ++i) {
    const auto& bgr = colors.at<cv::Vec3b>(i);
    table[static_cast<size_t>(i)] = Rgb(bgr[2], bgr[1], bgr[0]) / 255.f;
  }
  return table;
}

}  // namespace

Rgb viridis(float t) {
  static const std::array<Rgb, 256> table = makeTable();
  return table[static_cast<size_t>(std::lround(std::clamp(t, 0.f, 1.f) * 255.f))];
}

}  // namespace swaplight
