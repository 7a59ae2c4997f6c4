#pragma once

#include <opencv2/core.hpp>

namespace swaplight {

/// The picture whose gradients come closest to the given ones in the least-squares sense (free borders, mean
/// 0; Frankot and Chellappa 1988; Simchony et al. 1990), to within some thousandths
/// (core/linear/grid_poisson.h). 32-bit float; gx(y, x) belongs between x and x + 1, gy between y and y + 1;
/// the last column of gx and the last row of gy do not count.
[[nodiscard]] cv::Mat integrateGradients(const cv::Mat& gx, const cv::Mat& gy);

}  // namespace swaplight
