#include "core/solve/auto/pooling_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tests/support/processor_levels.h"

namespace swaplight {
namespace {

constexpr int kWidth = 48;

/// A band of one row with its margin, of random shares that sum to 1.
constexpr double kRejectChi2 = 9;

struct Scene {
  int lights, margin, stride;
  std::vector<std::vector<float>> planes;  ///< shares, variance, precision, guide
  PoolBand band;

  Scene(int lightCount, int step, bool clampAtZero)
      : lights(lightCount), margin(kPoolRadius * step), stride(kWidth + 2 * margin) {
    std::mt19937 random(unsigned(lights * 10 + step));
    std::uniform_real_distribution<float> unit(0, 1);
    band.rejects = float(lights == 2 ? kRejectChi2 : kRejectChi2 * lights);
    planes.assign(size_t(lights) + 3, std::vector<float>(size_t(stride) * size_t(2 * margin + 1)));
    for (size_t p = 0; p < planes[0].size(); ++p) {
      float sum = 0;
      for (int i = 0; i < lights; ++i) sum += planes[size_t(i)][p] = unit(random) - .15F;
      for (int i = 0; i < lights; ++i) planes[size_t(i)][p] += (1 - sum) / float(lights);
      const bool outside = p % 11 == 5;  // as beyond the picture's edge
      const float variance = .02F + .05F * unit(random);
      planes[size_t(lights)][p] = band.rejects * variance;
      planes[size_t(lights) + 1][p] = 1 / variance;
      planes[size_t(lights) + 2][p] = outside ? kNoPixel : 2 + .5F * unit(random);
    }
    const size_t first = size_t(margin) * size_t(stride) + size_t(margin);
    band.lights = lights, band.stride = stride, band.step = step, band.clampAtZero = clampAtZero;
    band.overlap = 1.5F, band.hiddenVariance = .1F;
    for (int i = 0; i < lights; ++i) band.share[i] = planes[size_t(i)].data() + first;
    band.limit = planes[size_t(lights)].data() + first;
    band.precision = planes[size_t(lights) + 1].data() + first;
    band.guide = planes[size_t(lights) + 2].data() + first;
  }

  [[nodiscard]] double variance(long x) const { return double(band.limit[x]) / band.rejects; }

  /// A pixel as pooling_kernel.h and share_pooling.h define it, in double.
  struct Pixel {
    std::vector<double> share;
    double left = 0;
  };
  [[nodiscard]] Pixel expected(int x) const {
    const int tested = lights == 2 ? 1 : lights;
    Pixel out{std::vector<double>(size_t(lights))};
    double total = 0, squares = 0, spread = 0, noiseThere = 0;
    for (int dy = -kPoolRadius; dy <= kPoolRadius; ++dy)
      for (int dx = -kPoolRadius; dx <= kPoolRadius; ++dx) {
        const long there = x + (long(dy) * stride + dx) * band.step;
        double difference = 0;
        for (int i = 0; i < tested; ++i)
          difference += square(double(band.share[i][there]) - band.share[i][x]);
        const double noise = variance(there) + variance(x);
        const double alike = std::max(0.0, 1 - difference / (kRejectChi2 * tested * noise));
        const double near = std::max(0.0, 1 - square(double(band.guide[there]) - band.guide[x]));
        const double weight = square(alike * near) * band.precision[there];
        spread += weight * difference, noiseThere += weight * variance(there);
        total += weight, squares += weight * weight * variance(there);
        for (int i = 0; i < lights; ++i) out.share[size_t(i)] += weight * band.share[i][there];
      }
    // Around the mean, not around the pixel; what the biweight leaves of noise is taken off.
    spread /= total;
    for (int i = 0; i < tested; ++i) spread -= square(out.share[size_t(i)] / total - band.share[i][x]);
    const double keptNoise = 1 / (1 + 2 / (kRejectChi2 * tested));
    const double real = std::max(spread / tested - keptNoise * noiseThere / total, 0.0);
    const double kept = real / (real + variance(x));
    double sum = 0;
    for (int i = 0; i < lights; ++i) {
      double& share = out.share[size_t(i)];
      share = (1 - kept) * share / total + kept * band.share[i][x];
      if (band.clampAtZero) share = std::max(share, 0.0);
      sum += share;
    }
    if (band.clampAtZero)
      for (double& share : out.share) share /= sum;
    const double pooled =
        squares / (total * total) * band.overlap + double(band.hiddenVariance) * variance(x);
    out.left = std::min(square(1 - kept) * pooled + kept * double(variance(x)), double(variance(x)));
    return out;
  }
  static double square(double x) { return x * x; }
};

TEST(PoolingKernel, IsTheSigmaFilterOfWhatIsNoiseAtEveryLevel) {
  for (const int lights : {2, 3, 4, 7, 16})
    for (const int step : {1, 2})
      for (const bool cut : {false, true}) {
        const Scene scene(lights, step, cut);
        std::vector<std::vector<float>> pooled(static_cast<size_t>(lights), std::vector<float>(kWidth));
        std::vector<float*> out;
        for (std::vector<float>& row : pooled) out.push_back(row.data());
        std::vector<float> left(kWidth);
        test::atEveryLevel([&] {
          SWAPLIGHT_KERNEL(poolRow)(scene.band, 0, kWidth, out.data(), left.data());
          for (int x = 0; x < kWidth; ++x) {
            if (scene.band.guide[x] == kNoPixel) continue;  // no pixel of the picture
            const Scene::Pixel expected = scene.expected(x);
            for (size_t i = 0; i < size_t(lights); ++i)
              ASSERT_NEAR(pooled[i][size_t(x)], expected.share[i], 1e-5) << lights << " lights, x " << x;
            ASSERT_NEAR(left[size_t(x)], expected.left, 1e-5 * expected.left + 1e-7) << x;
          }
        });
      }
}

}  // namespace
}  // namespace swaplight
