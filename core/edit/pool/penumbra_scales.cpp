#include "core/edit/pool/penumbra_scales.h"

#include <algorithm>
#include <array>
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

// How steep the visibility is (Sobel's slopes), where some of the light arrives: noise of what is lit counts
// less; and that times the slope once more. At column x of a row, between its columns `left` and `right`.
inline void slopeAt(const float* above, const float* row, const float* below, int left, int x, int right,
                    float* first, float* second) {
  const float across = above[right] - above[left] + 2 * (row[right] - row[left]) + below[right] - below[left];
  const float down = below[left] + 2 * below[x] + below[right] - above[left] - 2 * above[x] - above[right];
  const float slope = std::sqrt(across * across + down * down) * (1.F / 8);
  first[x] = slope * row[x] * (1 - row[x]);
  second[x] = first[x] * slope;
}

SWAPLIGHT_SIMD(void, slopesInside,
               (const float* __restrict above, const float* __restrict row, const float* __restrict below,
                int columns, float* __restrict first, float* __restrict second),
               (above, row, below, columns, first, second)) {
  for (int x = 1; x < columns - 1; ++x) slopeAt(above, row, below, x - 1, x, x + 1, first, second);
}

void slopesOf(const cv::Mat& visibility, cv::Mat& first, cv::Mat& second) {
  first.create(visibility.size(), CV_32F);
  second.create(visibility.size(), CV_32F);
  const int last = visibility.cols - 1;
  parallelRows(visibility.rows, 32, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const auto* above = visibility.ptr<float>(std::max(y - 1, 0));
      const auto* row = visibility.ptr<float>(y);
      const auto* below = visibility.ptr<float>(std::min(y + 1, visibility.rows - 1));
      auto* one = first.ptr<float>(y);
      auto* two = second.ptr<float>(y);
      slopesInside(above, row, below, visibility.cols, one, two);
      slopeAt(above, row, below, 0, 0, std::min(1, last), one, two);
      slopeAt(above, row, below, std::max(last - 1, 0), last, last, one, two);
    }
  });
}

/// Blurred, as a picture half, a quarter ... as large allows: adds `share` of it to `sum`.
void addBlurred(const cv::Mat& picture, double sigma, double shrink, double share, cv::Mat& sum) {
  const auto part = [&](int side) { return std::max(1, static_cast<int>(std::lround(side / shrink))); };
  cv::Mat blurred;
  cv::resize(picture, blurred, {part(picture.cols), part(picture.rows)}, 0, 0, cv::INTER_AREA);
  cv::GaussianBlur(blurred, blurred, {}, sigma / shrink, 0, cv::BORDER_REPLICATE);
  cv::resize(blurred, blurred, picture.size(), 0, 0, cv::INTER_LINEAR);
  sum += share * blurred;
}

// In pixels of the picture.
cv::Mat widthsOf(const cv::Mat& visibility, const cv::Mat& cone) {
  cv::Mat first;
  cv::Mat second;
  slopesOf(visibility, first, second);
  const cv::Size size = cone.size();
  cv::resize(first, first, size, 0, 0, cv::INTER_AREA);
  cv::resize(second, second, size, 0, 0, cv::INTER_AREA);
  first = first.mul(1 - cone);
  second = second.mul(1 - cone);
  cv::Mat above = cv::Mat::zeros(size, CV_32F);
  cv::Mat below = cv::Mat::zeros(size, CV_32F) + 1e-15;
  const double sigma = std::max(kNearest * size.width, .5);
  double farther = 1;
  double share = 1;
  for (int k = 0; k < kReaches; ++k, farther *= 2, share *= kFarther) {
    addBlurred(first, sigma * farther, farther, share, above);
    addBlurred(second, sigma * farther, farther, share, below);
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
  if (*most <= 0) return;
  std::array<std::array<float, kTogether>, 2> room;
  float* finer = room[0].data();
  float* coarser = room[1].data();
  std::copy_n(visibility, count, finer);
  float below = 0;
  for (size_t k = 0; k < m_levels.size() && below < *most; ++k) {
    const auto above = static_cast<float>(sigmaOf(k));
    const cv::Mat& level = m_levels[k];
    if (*least <= 2 * above)
      sampleRow(level, smallRow(x, y, {m_visibility.width(), m_visibility.height()}, level.size()), count,
                coarser);
    mixBlurs(finer, coarser, below, above, sigma, count, visibility);
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
