#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/set/solved_set.h"

namespace swaplight {

/// The lights of a set on few pixels, at unit white; 32-bit float, one channel each.
struct SmallLights {
  std::vector<cv::Mat> light;  ///< the mean of each light's channels
  cv::Mat sum;                 ///< of all lights, channels' mean
  cv::Mat color[3];            ///< of all lights, a channel each
};

/// At most `width` pixels wide.
[[nodiscard]] SmallLights smallLights(const SolvedSet& set, int width);

/// The value that this share of the pixels stay below.
[[nodiscard]] double quantileOf(const cv::Mat& values, double share);

}  // namespace swaplight
