#include "core/solve/neighbourhood.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <opencv2/imgproc.hpp>

#include "core/parallel.h"
#include "core/simd.h"
#include "core/solve/pixel_run.h"

namespace swaplight {
namespace {

constexpr int kRadius = 3;
constexpr int kBand = 48;
constexpr float kCertain = 1e-7F;  // a variance below which beta is not touched
constexpr float kTemper = 0.5F;

SWAPLIGHT_SIMD void weigh(const float* __restrict share, const float* __restrict variance,
                          float* __restrict w, float* __restrict wb, float* __restrict wbb, int count) {
  for (int x = 0; x < count; ++x) {
    const float weight = 1 / (variance[x] + kCertain);
    w[x] = weight;
    wb[x] = weight * share[x];
    wbb[x] = weight * share[x] * share[x];
  }
}

SWAPLIGHT_SIMD void shrink(const float* __restrict w, const float* __restrict wb, const float* __restrict wbb,
                           const float* __restrict variance, const float* __restrict share,
                           float* __restrict out, float* __restrict kept, int count) {
  for (int x = 0; x < count; ++x) {
    const float mean = wb[x] / w[x];
    const float spread = wbb[x] / w[x] - mean * mean;
    float signal = spread - 1 / w[x];
    signal = signal > 0 ? signal : 0;
    const float gain = (signal + kCertain) / (signal + variance[x] + kCertain);
    float b = mean + gain * (share[x] - mean);
    b = b > 0 ? b : 0;
    out[x] = b < 1 ? b : 1;
    kept[x] += gain;
  }
}

SWAPLIGHT_SIMD void normalise(float* const* planes, int lights, int count) {
  for (int x = 0; x < count; ++x) {
    float sum = 1e-12F;
    for (int i = 0; i < lights; ++i) sum += planes[i][x];
    for (int i = 0; i < lights; ++i) planes[i][x] /= sum;
  }
}

/// Of two lights' shares, one says all.
SWAPLIGHT_SIMD void complement(const float* __restrict share, float* __restrict other, int count) {
  for (int x = 0; x < count; ++x) other[x] = 1 - share[x];
}

/// The variance that is left: the kept part of the noise, and the mean's own. `kept`: the sum of `lights`
/// gains, replaced.
SWAPLIGHT_SIMD void leaveVariance(const float* __restrict variance, float* __restrict kept, int lights,
                                  int count) {
  constexpr float kMean = 1.0F / ((2 * kRadius + 1) * (2 * kRadius + 1));
  for (int x = 0; x < count; ++x) {
    const float gain = kept[x] / float(lights);
    kept[x] = variance[x] * (gain + (1 - gain) * kMean);
  }
}

}  // namespace

void poolShares(ImageView shares, ImageView variance, std::span<const ImageSpan> pooled, ImageSpan left) {
  const int width = shares.width;
  const int height = shares.height;
  const int lights = shares.channels;
  const int filtered = lights == 2 ? 1 : lights;
  const int bands = (height + kBand - 1) / kBand;
  parallelRows(bands, 1, [&](int begin, int end) {
    for (int band = begin; band < end; ++band) {
      const int top = band * kBand;
      const int bottom = std::min(top + kBand, height);
      const int first = std::max(top - kRadius, 0);
      const int last = std::min(bottom + kRadius, height);
      cv::Mat w(last - first, width, CV_32F), wb(w.size(), CV_32F), wbb(w.size(), CV_32F);
      cv::Mat sumW, sumWb, sumWbb;
      const cv::Size window(2 * kRadius + 1, 2 * kRadius + 1);
      for (int y = top; y < bottom; ++y) std::fill_n(left.row(0, y), width, 0.0F);
      for (int i = 0; i < filtered; ++i) {
        for (int y = first; y < last; ++y)
          weigh(shares.row(i, y), variance.row(0, y), w.ptr<float>(y - first), wb.ptr<float>(y - first),
                wbb.ptr<float>(y - first), width);
        if (i == 0) cv::boxFilter(w, sumW, CV_32F, window, {-1, -1}, true, cv::BORDER_REPLICATE);
        cv::boxFilter(wb, sumWb, CV_32F, window, {-1, -1}, true, cv::BORDER_REPLICATE);
        cv::boxFilter(wbb, sumWbb, CV_32F, window, {-1, -1}, true, cv::BORDER_REPLICATE);
        for (int y = top; y < bottom; ++y)
          shrink(sumW.ptr<float>(y - first), sumWb.ptr<float>(y - first), sumWbb.ptr<float>(y - first),
                 variance.row(0, y), shares.row(i, y), pooled[size_t(i)].row(0, y), left.row(0, y), width);
      }
      for (int y = top; y < bottom; ++y) {
        leaveVariance(variance.row(0, y), left.row(0, y), filtered, width);
        std::array<float*, kMaxLights> rows;
        for (int i = 0; i < lights; ++i) rows[size_t(i)] = pooled[size_t(i)].row(0, y);
        if (lights == 2)
          complement(rows[0], rows[1], width);
        else
          normalise(rows.data(), lights, width);
      }
    }
  });
}

void localOdds(ImageView misfit, float limit, ImageSpan odds) {
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
  const int bands = (height + kBand - 1) / kBand;
  parallelRows(bands, 1, [&](int begin, int end) {
    for (int band = begin; band < end; ++band) {
      const int top = band * kBand;
      const int bottom = std::min(top + kBand, height);
      const int first = std::max(top - kRadius, 0);
      const int last = std::min(bottom + kRadius, height);
      cv::Mat fails(last - first, width, CV_32F);
      for (int y = first; y < last; ++y)
        for (int x = 0; x < width; ++x)
          fails.at<float>(y - first, x) = misfit.row(0, y)[x] > limit ? 1.0F : 0.0F;
      cv::Mat local;
      cv::boxFilter(fails, local, CV_32F, {2 * kRadius + 1, 2 * kRadius + 1}, {-1, -1}, true,
                    cv::BORDER_REPLICATE);
      for (int y = top; y < bottom; ++y)
        for (int x = 0; x < width; ++x)
          odds.row(0, y)[x] = (local.at<float>(y - first, x) + kTemper * mean) / (mean * (1 + kTemper));
    }
  });
}

}  // namespace swaplight
