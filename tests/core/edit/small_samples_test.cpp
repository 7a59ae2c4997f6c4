#include "core/edit/pool/small_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace swaplight {
namespace {

cv::Mat wavy(int width, int height) {
  cv::Mat small(height, width, CV_32F);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) small.at<float>(y, x) = std::sin(float(x)) + .1F * float(y * y);
  return small;
}

float at(const cv::Mat& small, float x, float y) {
  const float px = std::clamp(x, 0.F, float(small.cols - 1)), py = std::clamp(y, 0.F, float(small.rows - 1));
  const int x0 = int(px), y0 = int(py);
  const int x1 = std::min(x0 + 1, small.cols - 1), y1 = std::min(y0 + 1, small.rows - 1);
  const float above = std::lerp(small.at<float>(y0, x0), small.at<float>(y0, x1), px - float(x0));
  const float below = std::lerp(small.at<float>(y1, x0), small.at<float>(y1, x1), px - float(x0));
  return std::lerp(above, below, py - float(y0));
}

/// From before the first pixel to beyond the last, at steps of a pixel and smaller.
TEST(SmallSamples, LieBetweenTheNearestPixels) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 5), cv::Size(2, 2), cv::Size(23, 7)}) {
    const cv::Mat small = wavy(size.width, size.height);
    for (const float step : {.0625F, .125F, .3F, .7F, 1.F})
      for (const float x : {-2.5F, -.5F, 0.F, .25F, 3.F})
        for (const float y : {-1.F, 0.F, 1.4F, 9.F})
          for (const int count : {0, 1, 3, 64, 300}) {
            std::vector<float> row(size_t(count), 0);
            sampleRow(small, {x, y, step}, count, row.data());
            for (int i = 0; i < count; ++i)
              ASSERT_NEAR(row[size_t(i)], at(small, x + step * float(i), y), 1e-5F)
                  << size << " step " << step << " from " << x << ", " << y << ": " << i;
          }
  }
}

}  // namespace
}  // namespace swaplight
