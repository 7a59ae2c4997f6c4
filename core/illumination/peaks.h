#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace swaplight {

/// A local maximum of a picture.
struct Peak {
  int x = 0, y = 0;
  double prominence = 0;  ///< how far one has to go down from it to get to a higher one; of the highest: to
                          ///< the lowest place
};

/// All peaks of a 32-bit float picture, most prominent first. Neighbours are eight.
[[nodiscard]] std::vector<Peak> peaksOf(const cv::Mat& picture);

}  // namespace swaplight
