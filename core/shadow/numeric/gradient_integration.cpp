#include "core/shadow/numeric/gradient_integration.h"

#include <span>

#include "core/base/parallel.h"
#include "core/linear/grid_poisson.h"

namespace swaplight {

cv::Mat integrateGradients(const cv::Mat& gx, const cv::Mat& gy) {
  const int width = gx.cols;
  cv::Mat divergence(gx.size(), CV_32F), result(gx.size(), CV_32F);
  parallelRows(gx.rows, 64, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      auto* out = divergence.ptr<float>(y);
      const auto* across = gx.ptr<float>(y);
      out[0] = width > 1 ? -across[0] : 0;
      for (int x = 1; x + 1 < width; ++x) out[x] = across[x - 1] - across[x];
      if (width > 1) out[width - 1] = across[width - 2];
      if (y > 0)
        for (int x = 0; x < width; ++x) out[x] += gy.at<float>(y - 1, x);
      if (y + 1 < gx.rows)
        for (int x = 0; x < width; ++x) out[x] -= gy.at<float>(y, x);
    }
  });
  const std::span wanted(divergence.ptr<float>(), divergence.total());
  solvePoisson(width, gx.rows, wanted, std::span(result.ptr<float>(), result.total()));
  return result;
}

}  // namespace swaplight
