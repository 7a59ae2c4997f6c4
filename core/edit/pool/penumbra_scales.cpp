#include "core/edit/pool/penumbra_scales.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"
#include "core/edit/pool/small_samples.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr int kMeasured = 384;    // of the small pictures in which widths are measured
constexpr double kNearest = .01;  // widths of the picture: edges that a pixel looks for first
constexpr int kReaches = 4;       // each twice as far
constexpr double kFarther = .01;  // how much less what is farther counts
constexpr float kNarrowest = 2;   // pixels
constexpr float kRamp = .289F;    // standard deviation of a linear ramp, of its width
/// Of the lamp's diameter: things stand within a fifth of the way to the lamp from what their shadow falls
/// on.
constexpr float kWidest = .25F;
constexpr double kFade = .1;      // radii
constexpr double kMostBlur = .2;  // widths of the picture
constexpr double kFinest = 2;     // pixels of a small picture: what it may be blurred by at least
constexpr float kSteepest = .05F;
constexpr int kTogether = 32;  // pixels of a row

cv::Mat matOf(const Image& image) {
  return {image.height(), image.width(), CV_32F, const_cast<float*>(image.plane(0))};
}

cv::Size sizeWithin(const cv::Size& size, int width) {
  const int columns = std::min(width, size.width);
  return {columns, std::max(1, static_cast<int>(std::lround(1. * size.height * columns / size.width)))};
}

cv::Mat nearCone(const cv::Size& size, const std::optional<LightCone>& cone) {
  cv::Mat near = cv::Mat::zeros(size, CV_32F);
  if (!cone) return near;
  const double half = .5 * cone->softness + cone->unsure();
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const double radius =
          cone->radius((x + .5) / size.width - .5, (.5 * size.height - (y + .5)) / size.width);
      near.at<float>(y, x) =
          static_cast<float>(std::clamp((half + kFade - std::abs(radius - 1)) / kFade, 0., 1.));
    }
  return near;
}

// In pixels of the picture.
cv::Mat widthsOf(const cv::Mat& visibility, const cv::Mat& cone) {
  cv::Mat across;
  cv::Mat down;
  cv::Sobel(visibility, across, CV_32F, 1, 0, 3, 1. / 8, 0, cv::BORDER_REPLICATE);
  cv::Sobel(visibility, down, CV_32F, 0, 1, 3, 1. / 8, 0, cv::BORDER_REPLICATE);
  cv::Mat slope;
  cv::magnitude(across, down, slope);
  // Where some of the light arrives: noise of what is lit counts less.
  cv::Mat first = slope.mul(visibility).mul(1 - visibility);
  cv::Mat second = first.mul(slope);
  const cv::Size size = cone.size();
  cv::resize(first, first, size, 0, 0, cv::INTER_AREA);
  cv::resize(second, second, size, 0, 0, cv::INTER_AREA);
  first = first.mul(1 - cone);
  second = second.mul(1 - cone);
  cv::Mat above = cv::Mat::zeros(size, CV_32F);
  cv::Mat below = cv::Mat::zeros(size, CV_32F) + 1e-15;
  double share = 1;
  double sigma = std::max(kNearest * size.width, .5);
  for (int k = 0; k < kReaches; ++k, sigma *= 2, share *= kFarther) {
    cv::Mat blurred;
    cv::GaussianBlur(first, blurred, {}, sigma, 0, cv::BORDER_REPLICATE);
    above += share * blurred;
    cv::GaussianBlur(second, blurred, {}, sigma, 0, cv::BORDER_REPLICATE);
    below += share * blurred;
  }
  return above / below;
}

/// `small`: the picture of size `full` as the blur before, a smaller one, has shrunk it.
cv::Mat blurredBy(cv::Mat& small, const cv::Size& full, double sigma) {
  const double shrink = std::max(1., sigma / kFinest);
  if (shrink > 1) {
    const cv::Size size(std::max(1, static_cast<int>(std::lround(full.width / shrink))),
                        std::max(1, static_cast<int>(std::lround(full.height / shrink))));
    cv::resize(small, small, size, 0, 0, cv::INTER_AREA);
  }
  // Shrinking and enlarging blur, too: a box and a tent.
  const double left = std::max(sigma * sigma / (shrink * shrink) - (shrink > 1 ? .25 : 0.), .01);
  cv::Mat blurred(small.size(), CV_32F);
  parallelRows(small.rows, 64, [&](int begin, int end) {
    cv::Mat band = blurred.rowRange(begin, end);  // sees the rows around it
    cv::GaussianBlur(small.rowRange(begin, end), band, {}, std::sqrt(left), 0, cv::BORDER_REPLICATE);
  });
  return blurred;
}

// Standard deviations, pixels, from the widths of edges.
SWAPLIGHT_SIMD(void, blursFor,
               (const float* width, const float* cone, float widest, float times, float most, int count,
                float* sigma),
               (width, cone, widest, times, most, count, sigma)) {
  for (int i = 0; i < count; ++i) {
    const float edge = std::min(width[i], widest);
    const float own = (1 - cone[i]) * kRamp * std::sqrt(std::max(edge * edge - kNarrowest * kNarrowest, 0.F));
    sigma[i] = std::min(own * times, most);
  }
}

// Of pixels whose blur lies between two: the variance of a mixture is the mixture of the variances.
SWAPLIGHT_SIMD(void, mixBlurs,
               (const float* finer, const float* coarser, float below, float above, const float* sigma,
                int count, float* visibility),
               (finer, coarser, below, above, sigma, count, visibility)) {
  const float scale = 1 / (above * above - below * below);
  for (int i = 0; i < count; ++i) {
    const float part = (sigma[i] * sigma[i] - below * below) * scale;
    const float mixed = finer[i] + part * (coarser[i] - finer[i]);
    visibility[i] = sigma[i] > below && sigma[i] <= above ? mixed : visibility[i];
  }
}

double sigmaOf(size_t level) {
  return std::exp2(static_cast<double>(level));
}

}  // namespace

PenumbraScales::PenumbraScales(const Image& visibility, const std::optional<LightCone>& cone)
    : m_visibility(visibility),
      m_cone(nearCone(sizeWithin({visibility.width(), visibility.height()}, kMeasured), cone)),
      m_width(widthsOf(matOf(visibility), m_cone)) {
  const cv::Mat full = matOf(visibility);
  cv::Mat small = full;
  for (size_t k = 0; k == 0 || sigmaOf(k - 1) < kMostBlur * full.cols; ++k)
    m_levels.push_back(blurredBy(small, full.size(), sigmaOf(k)));
}

void PenumbraScales::sigmaRow(float times, float diameter, const float* width, const float* cone, int count,
                              float* sigma) const {
  const float pixels = diameter * static_cast<float>(m_visibility.width());
  const float more = std::abs(times * times - 1);
  const float most = static_cast<float>(sigmaOf(m_levels.size() - 1));
  blursFor(width, cone, kWidest * pixels, std::sqrt(more), most, count, sigma);
}

void PenumbraScales::blurRow(int x, int y, int count, const float* sigma, float* visibility) const {
  const auto [least, most] = std::minmax_element(sigma, sigma + count);
  std::vector<float> finer(visibility, visibility + count);
  std::vector<float> coarser(finer.size());
  float below = 0;
  for (size_t k = 0; k < m_levels.size() && below < *most; ++k) {
    const auto above = static_cast<float>(sigmaOf(k));
    const cv::Mat& level = m_levels[k];
    if (*least < 2 * above)
      sampleRow(level, smallRow(x, y, {m_visibility.width(), m_visibility.height()}, level.size()), count,
                coarser.data());
    mixBlurs(finer.data(), coarser.data(), below, above, sigma, count, visibility);
    std::swap(finer, coarser);
    below = above;
  }
}

void PenumbraScales::row(float times, float diameter, int x, int y, int count, float* visibility) const {
  const float* now = m_visibility.view().row(0, y) + x;
  std::copy_n(now, count, visibility);
  const auto size = static_cast<size_t>(count);
  std::vector<float> width(size);
  std::vector<float> cone(size);
  std::vector<float> sigma(size);
  const SmallRow place = smallRow(x, y, {m_visibility.width(), m_visibility.height()}, m_width.size());
  sampleRow(m_width, place, count, width.data());
  sampleRow(m_cone, place, count, cone.data());
  sigmaRow(times, diameter, width.data(), cone.data(), count, sigma.data());
  if (times >= 1) {
    // Neighbours need much the same blurs, a whole row many.
    for (int from = 0; from < count; from += kTogether)
      blurRow(x + from, y, std::min(kTogether, count - from), sigma.data() + from, visibility + from);
    return;
  }
  for (size_t i = 0; i < size; ++i) {
    if (!(width[i] > 0)) continue;
    // A ramp that loses this much of its variance.
    const float lost = sigma[i] / (kRamp * width[i]);
    const float narrower = std::sqrt(std::max(1 - lost * lost, kSteepest * kSteepest));
    visibility[i] = std::clamp((now[i] - .5F) / narrower + .5F, 0.F, 1.F);
  }
}

}  // namespace swaplight
