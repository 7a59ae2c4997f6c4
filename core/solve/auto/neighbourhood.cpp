#include "core/solve/auto/neighbourhood.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr int kBandRows = 48;

}  // namespace

void localOdds(ImageView misfit, float freedom, const NeighbourhoodTuning& tuning, ImageSpan odds) {
  const float limit = freedom + tuning.limit * std::sqrt(2 * freedom);
  const int width = misfit.width;
  const int height = misfit.height;
  std::atomic<long> failed = 0;
  parallelRows(height, 64, [&](int begin, int end) {
    long count = 0;
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < width; ++x) count += misfit.row(0, y)[x] > limit;
    failed += count;
  });
  const float mean = float(double(failed) / (double(width) * double(height)));
  if (mean <= 0) {
    for (int y = 0; y < height; ++y) std::fill_n(odds.row(0, y), width, 1.0F);
    return;
  }
  const int bands = (height + kBandRows - 1) / kBandRows;
  parallelEach(bands, [&](int band) {
    const int top = band * kBandRows;
    const int bottom = std::min(top + kBandRows, height);
    const int first = std::max(top - tuning.radius, 0);
    const int last = std::min(bottom + tuning.radius, height);
    cv::Mat fails(last - first, width, CV_32F);
    for (int y = first; y < last; ++y)
      for (int x = 0; x < width; ++x)
        fails.at<float>(y - first, x) = misfit.row(0, y)[x] > limit ? 1.0F : 0.0F;
    cv::Mat local;
    cv::boxFilter(fails, local, CV_32F, {2 * tuning.radius + 1, 2 * tuning.radius + 1}, {-1, -1}, true,
                  cv::BORDER_REPLICATE);
    for (int y = top; y < bottom; ++y)
      for (int x = 0; x < width; ++x)
        odds.row(0, y)[x] =
            (local.at<float>(y - first, x) + tuning.temper * mean) / (mean * (1 + tuning.temper));
  });
}

}  // namespace swaplight
