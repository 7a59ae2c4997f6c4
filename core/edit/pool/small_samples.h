#pragma once

#include <opencv2/core.hpp>

namespace swaplight {

/// Where a row of pixels lies in a small picture: pixel i at (x + step * i, y), in its pixels; 0 is the
/// middle of its first. step: 0..1.
struct SmallRow {
  float x = 0, y = 0;
  float step = 1;
};

/// The row `y` from pixel `x` on of a picture of `size` in one that was shrunk from it to `small`.
[[nodiscard]] SmallRow smallRow(int x, int y, const cv::Size& size, const cv::Size& small);

/// Values of a small picture (32-bit float, one channel) along a row, linear between its pixels; beyond its
/// border they go on as they are there.
void sampleRow(const cv::Mat& small, const SmallRow& row, int count, float* out);

}  // namespace swaplight
