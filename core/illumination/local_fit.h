#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <vector>

namespace swaplight {

/// A picture that a fit explains another one with.
struct FitGuide {
  cv::Mat values;
  double ridge = 1e-3;  ///< the variance of `values` below which it explains little
};

/// How a picture follows others around each pixel: target = offset + sum of slopes[k] * guides[k], by least
/// squares under a Gaussian window, the coefficients averaged under it again (the guided filter of He, Sun
/// and Tang, 2013, with several guides and weights). All pictures are 32-bit float, one channel, of one size.
struct LocalFit {
  std::vector<cv::Mat> slopes;  ///< one a guide
  cv::Mat offset;
};

/// `weight` >= 0: how much a pixel counts. `sigma` of the window in pixels.
[[nodiscard]] LocalFit fitLocally(const cv::Mat& target, std::span<const FitGuide> guides,
                                  const cv::Mat& weight, double sigma);

}  // namespace swaplight
