#include "core/shadow/evidence/shared_reflectance.h"

#include <cmath>
#include <span>

#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/shadow/numeric/gradient_integration.h"

namespace swaplight {
namespace {

// Towards the right and the lower neighbour.
void gradients(const cv::Mat& x, cv::Mat& gx, cv::Mat& gy) {
  gx = cv::Mat::zeros(x.size(), CV_32F);
  gy = cv::Mat::zeros(x.size(), CV_32F);
  if (x.cols > 1) gx.colRange(0, x.cols - 1) = x.colRange(1, x.cols) - x.colRange(0, x.cols - 1);
  if (x.rows > 1) gy.rowRange(0, x.rows - 1) = x.rowRange(1, x.rows) - x.rowRange(0, x.rows - 1);
}

// What several gradients have in common at each pixel.
cv::Mat sharedGradient(const std::vector<cv::Mat>& g) {
  cv::Mat shared(g.front().size(), CV_32F, cv::Scalar(0));
  parallelRows(shared.rows, 32, [&](int begin, int end) {
    std::vector<float> values(g.size());
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < shared.cols; ++x) {
        for (size_t i = 0; i < g.size(); ++i) values[i] = g[i].at<float>(y, x);
        float& out = shared.at<float>(y, x);
        if (g.size() == 2) {
          const bool sameSign = values[0] * values[1] > 0;
          out = sameSign ? (std::abs(values[0]) < std::abs(values[1]) ? values[0] : values[1]) : 0;
        } else if (g.size() > 2) {
          out = static_cast<float>(interpolatedQuantile(std::span(values), .5));
        }
      }
  });
  return shared;
}

}  // namespace

cv::Mat sharedReflectance(const std::vector<cv::Mat>& logs) {
  std::vector<cv::Mat> across(logs.size());
  std::vector<cv::Mat> down(logs.size());
  for (size_t i = 0; i < logs.size(); ++i) gradients(logs[i], across[i], down[i]);
  return integrateGradients(sharedGradient(across), sharedGradient(down));
}

}  // namespace swaplight
