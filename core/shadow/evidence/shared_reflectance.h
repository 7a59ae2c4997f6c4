#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace swaplight {

/// Reflectance is what changes under all lights alike: the gradients of log contributions that the lights
/// share (the smaller of two; the median of three and more, after Weiss, "Deriving intrinsic images from
/// image sequences", ICCV 2001), integrated. `logs`: 32-bit float, all of one size; the result is the log of
/// the reflectance up to a constant (mean 0), and 0 for a single light.
[[nodiscard]] cv::Mat sharedReflectance(const std::vector<cv::Mat>& logs);

}  // namespace swaplight
