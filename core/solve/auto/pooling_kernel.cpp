#include "core/solve/auto/pooling_kernel.h"

#include "core/simd/lanes.h"

namespace swaplight::SWAPLIGHT_LEVEL {
namespace {

constexpr float kTiny = 1e-12F;

/// Shares below zero become zero, the others give way.
template <int kN>
SWAPLIGHT_LANES void clampAtZero(int n, Lanes* share) {
  Lanes sum = splat(kTiny);
  for (int i = 0; i < n; ++i) {
    share[i] = larger(share[i], splat(0));
    sum += share[i];
  }
  const Lanes scale = 1 / sum;
  for (int i = 0; i < n; ++i) share[i] *= scale;
}

template <int kN>
[[gnu::always_inline]] inline void pool(const PoolBand& band, int row, int width, float* const* pooled,
                                        float* left, int lights) {
  const int n = lights;
  const int tested = n == 2 ? 1 : n;  // of two shares, one says all
  // The biweight of two values of the variance v is nearly a normal one of `rejects` v / 2 a share: of noise
  // alone, that leaves so much of the variance.
  const float keptNoise = band.rejects / (band.rejects + 2);
  const long first = long(row) * band.stride;
  for (int x = 0; x < width; x += kLanes) {
    const long at = first + x;
    const Lanes guide = load(band.guide + at);
    const Lanes limit = load(band.limit + at);
    Lanes share[kN];
    Lanes sum[kN];
    for (int i = 0; i < n; ++i) {
      share[i] = load(band.share[i] + at);
      sum[i] = splat(0);
    }
    Lanes total = splat(0);
    Lanes squares = splat(0);
    Lanes spread = splat(0);
    Lanes noise = splat(0);
    for (int dy = -kPoolRadius; dy <= kPoolRadius; ++dy)
      for (int dx = -kPoolRadius; dx <= kPoolRadius; ++dx) {
        const long there = at + (long(dy) * band.stride + dx) * band.step;
        Lanes apart[kN];
        Lanes difference = splat(0);
        for (int i = 0; i < tested; ++i) {
          apart[i] = load(band.share[i] + there) - share[i];
          difference += apart[i] * apart[i];
        }
        const Lanes step = load(band.guide + there) - guide;
        const Lanes alike =
            larger(1 - difference * roughReciprocal(load(band.limit + there) + limit), splat(0));
        const Lanes near = larger(1 - step * step, splat(0));
        const Lanes both = alike * near;
        const Lanes weighted = both * both;  // the weight times the variance
        const Lanes weight = weighted * load(band.precision + there);
        total += weight;
        squares += weight * weighted;
        noise += weighted;
        spread += weight * difference;
        for (int i = 0; i < tested; ++i) sum[i] += weight * apart[i];
      }
    total = 1 / larger(total, splat(1e-30F));
    // The squared distance from the mean, a share: spread was from the pixel.
    spread *= total;
    for (int i = 0; i < tested; ++i) {
      sum[i] *= total;
      spread -= sum[i] * sum[i];
    }
    // What it is more than noise is the neighbourhood's own, and a pixel keeps as much of its own.
    const Lanes real = larger(spread * (1 / float(tested)) - keptNoise * noise * total, splat(0));
    const Lanes variance = limit * (1 / band.rejects);
    const Lanes kept = real / (real + variance);
    const Lanes given = 1 - kept;
    for (int i = 0; i < tested; ++i) share[i] += given * sum[i];
    if (n == 2) share[1] = 1 - share[0];
    if (band.clampAtZero) clampAtZero<kN>(n, share);
    for (int i = 0; i < n; ++i) store(pooled[i] + x, share[i]);
    const Lanes known = squares * total * total * band.overlap + band.hiddenVariance * variance;
    store(left + x, smaller(given * given * known + kept * variance, variance));
  }
}

}  // namespace

void poolRow(const PoolBand& band, int row, int width, float* const* pooled, float* left) {
  switch (band.lights) {
    case 2:
      return pool<2>(band, row, width, pooled, left, 2);
    case 3:
      return pool<3>(band, row, width, pooled, left, 3);
    case 4:
      return pool<4>(band, row, width, pooled, left, 4);
    default:
      return pool<kMaxLights>(band, row, width, pooled, left, band.lights);
  }
}

}  // namespace swaplight::SWAPLIGHT_LEVEL
