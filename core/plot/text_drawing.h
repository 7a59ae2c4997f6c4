#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace swaplight {

/// Text into an 8-bit picture of three channels: in the Inter typeface where it is installed, else in
/// OpenCV's built-in strokes. UTF-8. `height` is that of a line in pixels. Safe to call from several threads.
void drawText(cv::Mat& image, const std::string& text, cv::Point leftBaseline, int height,
              const cv::Scalar& color);

/// The box of the text as drawn: its width, and its height above the baseline.
[[nodiscard]] cv::Size textSize(const std::string& text, int height);

}  // namespace swaplight
