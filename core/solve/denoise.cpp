#include "core/solve/denoise.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "core/parallel.h"

namespace swaplight {
namespace {

constexpr float kCertain = 1e-6F;  // a variance of beta that no one sees
constexpr float kFlat = 0.03F;     // guide: steps below it are no edge; 1 is a bright part of the set
constexpr int kGuard = 2;          // pixels: radius of the windows that look for lost edges
constexpr float kNoise = 0.4F;     // what noise alone makes of a window's mean difference, in sigma
constexpr float kEdge = 0.7F;      // what can only be an edge

cv::Mat boxed(const cv::Mat& in, int radius) {
  cv::Mat out;
  cv::boxFilter(in, out, CV_32F, {2 * radius + 1, 2 * radius + 1}, {-1, -1}, true, cv::BORDER_REPLICATE);
  return out;
}

cv::Mat ratio(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat out;
  cv::divide(a, b, out);
  return out;
}

/// Planes that every light's filter shares.
struct Guide {
  int radius;
  cv::Mat picture;        ///< cube root of the sum, about 0..1
  cv::Mat variance;       ///< of beta, a pixel's own
  cv::Mat weight;         ///< 1 / variance
  cv::Mat total;          ///< box of weight
  cv::Mat mean, inverse;  ///< of the picture: weighted mean, 1 / (weighted variance + flat)
  cv::Mat totalTwice;
  cv::Mat localVariance;

  Guide(const SolvedSet& set, const EstimatorContext& context, int r)
      : radius(r), picture(set.height(), set.width(), CV_32F), variance(picture.size(), CV_32F) {
    fillPlanes(set, context);
    weight = 1 / (variance + kCertain);
    total = boxed(weight, r);
    mean = ratio(boxed(weight.mul(picture), r), total);
    cv::Mat spread = ratio(boxed(weight.mul(picture).mul(picture), r), total) - mean.mul(mean);
    inverse = 1 / (cv::max(spread, 0) + kFlat * kFlat);
    totalTwice = boxed(total, r);
    localVariance = boxed(variance, kGuard) + kCertain;
  }

 private:
  void fillPlanes(const SolvedSet& set, const EstimatorContext& context) {
    const LightPlan& plan = context.plan;
    float color = 0;
    for (const Rgb& c : plan.colors) color += (c.r + c.g + c.b) / (3 * float(plan.colors.size()));
    const float* sigma = set.quality.plane(kSigma);
    auto* guide = picture.ptr<float>();
    auto* v = variance.ptr<float>();
    const size_t count = set.beta.pixelCount();
    for (size_t p = 0; p < count; ++p) {
      float sum = 0;
      for (const Image& t : set.contributions) sum += (t.plane(0)[p] + t.plane(1)[p] + t.plane(2)[p]) / 3;
      guide[p] = sum;
      const float signal = color * sum;
      const float own = context.noise.constant + context.noise.linear * signal;
      const float all = own + context.noise.square * signal * signal;
      v[p] = sigma[p] * sigma[p] * (all > 0 ? own / all : 1);
    }
    std::vector<float> sample;
    for (size_t p = 0; p < count; p += std::max<size_t>(1, count / 50000)) sample.push_back(guide[p]);
    const auto bright = sample.begin() + long(sample.size() * 95 / 100);
    std::nth_element(sample.begin(), bright, sample.end());
    const float scale = 1 / std::max(*bright, 1e-9F);
    for (size_t p = 0; p < count; ++p) guide[p] = std::cbrt(guide[p] * scale);
  }
};

/// Where beta and beta' are apart on one side of a pixel at least: the largest of four windows' mean
/// differences, in sigma. (One window around the pixel would find nothing at the edge itself, where the
/// difference changes its sign.)
cv::Mat apart(const cv::Mat& difference, const cv::Mat& localVariance) {
  const cv::Mat mean = boxed(difference, kGuard);
  cv::Mat squared = cv::Mat::zeros(mean.size(), CV_32F);
  cv::Mat padded;
  cv::copyMakeBorder(mean, padded, kGuard, kGuard, kGuard, kGuard, cv::BORDER_REPLICATE);
  for (const auto& [x, y] : {std::pair{0, 1}, {2, 1}, {1, 0}, {1, 2}}) {
    const cv::Mat side = padded({x * kGuard, y * kGuard, mean.cols, mean.rows});
    squared = cv::max(squared, side.mul(side));
  }
  cv::Mat out;
  cv::sqrt(squared / localVariance, out);
  return out;
}

/// beta' of one light.
cv::Mat filtered(const Guide& guide, const cv::Mat& beta) {
  const cv::Mat weighted = guide.weight.mul(beta);
  const cv::Mat mean = ratio(boxed(weighted, guide.radius), guide.total);
  const cv::Mat both = ratio(boxed(weighted.mul(guide.picture), guide.radius), guide.total);
  const cv::Mat slope = (both - guide.mean.mul(mean)).mul(guide.inverse);
  const cv::Mat offset = mean - slope.mul(guide.mean);
  const cv::Mat a = ratio(boxed(slope.mul(guide.total), guide.radius), guide.totalTwice);
  const cv::Mat b = ratio(boxed(offset.mul(guide.total), guide.radius), guide.totalTwice);
  return a.mul(guide.picture) + b;
}

}  // namespace

void denoiseGuided(SolvedSet& set, const EstimatorContext& context, int radius) {
  const int lights = set.lightCount();
  const int height = set.height();
  const int width = set.width();
  const Guide guide(set, context, radius);

  std::vector<cv::Mat> beta, smooth;
  for (int i = 0; i < lights; ++i) {
    beta.emplace_back(height, width, CV_32F, set.beta.plane(i));
    smooth.emplace_back();
  }
  // Of all lights, the one that asks for most care.
  std::vector<cv::Mat> excess(static_cast<size_t>(lights));
  parallelRows(lights, 1, [&](int begin, int end) {
    for (auto i = size_t(begin); i < size_t(end); ++i) {
      smooth[i] = filtered(guide, beta[i]);
      excess[i] = apart(smooth[i] - beta[i], guide.localVariance);
    }
  });
  for (size_t i = 1; i < excess.size(); ++i) excess[0] = cv::max(excess[0], excess[i]);

  parallelRows(height, 32, [&](int begin, int end) {
    std::vector<float> after(static_cast<size_t>(lights));
    for (size_t p = size_t(begin) * size_t(width); p < size_t(end) * size_t(width); ++p) {
      const float edge = excess[0].ptr<float>()[p];
      const float taken = std::clamp((kEdge - edge) / (kEdge - kNoise), 0.0F, 1.0F);
      if (taken <= 0) continue;
      float total = 0;
      for (size_t i = 0; i < after.size(); ++i) {
        const float before = beta[i].ptr<float>()[p];
        after[i] = std::clamp(before + taken * (smooth[i].ptr<float>()[p] - before), 0.0F, 1.0F);
        total += after[i];
      }
      if (!(total > 0)) continue;
      for (int c = 0; c < 3; ++c) {
        float sum = 0;
        for (const Image& t : set.contributions) sum += t.plane(c)[p];
        float moved = 0;
        for (size_t i = 0; i < after.size(); ++i) {
          float& t = set.contributions[i].plane(c)[p];
          t = std::max(t + (after[i] / total - beta[i].ptr<float>()[p]) * sum, 0.0F);
          moved += t;
        }
        if (moved > 0)
          for (Image& t : set.contributions) t.plane(c)[p] *= sum / moved;
      }
    }
  });
}

}  // namespace swaplight
