#include "core/solve/auto/share_pooling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/simd/padding.h"
#include "core/simd/simd.h"
#include "core/solve/auto/pooling_kernel.h"

namespace swaplight {
namespace {

constexpr int kBand = 32;           // rows
constexpr float kCertain = 1e-12F;  // a variance below which beta is not touched

SWAPLIGHT_SIMD(void, invert,
               (const float* __restrict variance, float rejects, float* __restrict limit,
                float* __restrict precision, int count),
               (variance, rejects, limit, precision, count)) {
  for (int x = 0; x < count; ++x) {
    const float raised = variance[x] > kCertain ? variance[x] : kCertain;
    limit[x] = rejects * raised;
    precision[x] = 1 / raised;
  }
}

SWAPLIGHT_SIMD(void, scale, (const float* __restrict from, float factor, float* __restrict to, int count),
               (from, factor, to, count)) {
  for (int x = 0; x < count; ++x) to[x] = factor * from[x];
}

/// The memory of a band.
class Band {
 public:
  Band(int lights, int width, const SharePooling& options)
      : m_margin(kPoolRadius * options.step),
        m_width(int(roundedUpToLanes(size_t(width)))),
        m_guideScale(1 / options.guideStep) {
    m_band.lights = lights;
    m_band.stride = m_width + 2 * m_margin;
    m_band.step = options.step;
    // Of two shares, one says all.
    m_band.rejects = options.rejectChi2 * float(lights == 2 ? 1 : lights);
    m_band.overlap = options.overlap;
    m_band.hiddenVariance = options.hiddenVariance;
    m_band.clampAtZero = options.clampAtZero;
    m_rows = kBand + 2 * m_margin;
    m_data.resize(size_t(lights + 3) * size_t(m_rows) * size_t(m_band.stride), 0.0F);
    m_row.resize(size_t(lights + 1) * size_t(m_width));
    for (int i = 0; i < lights; ++i) m_band.share[i] = plane(i, 0);
    m_band.limit = plane(lights, 0);
    m_band.precision = plane(lights + 1, 0);
    m_band.guide = plane(lights + 2, 0);
    // Beyond the picture nothing is alike, and there are limits that can be divided by.
    std::fill_n(plane(lights, -m_margin) - m_margin, size_t(m_rows) * size_t(m_band.stride), 1.0F);
    std::fill_n(plane(lights + 2, -m_margin) - m_margin, size_t(m_rows) * size_t(m_band.stride), kNoPixel);
  }

  void load(std::span<const ImageSpan> shares, ImageView variance, ImageView guide, int top) {
    const int lights = m_band.lights;
    for (int row = -m_margin; row < kBand + m_margin; ++row) {
      const int y = top + row;
      if (y < 0 || y >= variance.height) {
        std::fill_n(plane(lights + 2, row), m_width, kNoPixel);
        continue;
      }
      for (int i = 0; i < lights; ++i)
        std::copy_n(shares[size_t(i)].row(0, y), variance.width, plane(i, row));
      invert(variance.row(0, y), m_band.rejects, plane(lights, row), plane(lights + 1, row), variance.width);
      scale(guide.row(0, y), m_guideScale, plane(lights + 2, row), variance.width);
    }
  }

  void pool(std::span<const ImageSpan> pooled, ImageSpan left, int top, int row) {
    std::array<float*, kMaxLights> out{};
    for (int i = 0; i < m_band.lights; ++i) out[size_t(i)] = m_row.data() + size_t(i) * size_t(m_width);
    float* variance = m_row.data() + size_t(m_band.lights) * size_t(m_width);
    SWAPLIGHT_KERNEL(poolRow)(m_band, row, m_width, out.data(), variance);
    for (int i = 0; i < m_band.lights; ++i)
      std::copy_n(out[size_t(i)], left.width, pooled[size_t(i)].row(0, top + row));
    std::copy_n(variance, left.width, left.row(0, top + row));
  }

 private:
  float* plane(int which, int row) {
    return m_data.data() + (size_t(which) * size_t(m_rows) + size_t(row + m_margin)) * size_t(m_band.stride) +
           m_margin;
  }

  PoolBand m_band;
  int m_margin, m_width, m_rows = 0;
  float m_guideScale;
  std::vector<float> m_data, m_row;
};

}  // namespace

void poolShares(std::span<const ImageSpan> shares, ImageView variance, ImageView guide,
                const SharePooling& options, std::span<const ImageSpan> pooled, ImageSpan left) {
  const int bands = (variance.height + kBand - 1) / kBand;
  parallelRows(bands, 4, [&](int begin, int end) {
    Band band(int(shares.size()), variance.width, options);
    for (int b = begin; b < end; ++b) {
      const int top = b * kBand;
      band.load(shares, variance, guide, top);
      for (int row = 0; row < std::min(kBand, variance.height - top); ++row)
        band.pool(pooled, left, top, row);
    }
  });
}

std::vector<ImageSpan> planesOf(Image& shares) {
  std::vector<ImageSpan> planes;
  planes.reserve(size_t(shares.channelCount()));
  for (int i = 0; i < shares.channelCount(); ++i) planes.push_back(shares.span().channelRange(i, 1));
  return planes;
}

float guideStep(ImageView guide, const NoiseModel& noise, const PoolingTuning& tuning) {
  std::vector<float> sample;
  const size_t count = size_t(guide.width) * size_t(guide.height);
  const size_t every = std::max<size_t>(1, count / 20000);
  sample.reserve(count / every + 1);
  for (size_t p = 0; p < count; p += every) sample.push_back(guide.row(0, 0)[p]);
  const float bright = quantile(std::span(sample), tuning.guideLevel);
  return 2 * std::sqrt(tuning.guideStep * tuning.guideStep * bright * bright + noise.linear / 2);
}

}  // namespace swaplight
