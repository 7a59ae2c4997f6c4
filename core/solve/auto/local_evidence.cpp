#include "core/solve/auto/local_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/base/parallel.h"
#include "core/linear/decompositions.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr int kRowsTogether = 16;

/// A direction of the contributions of a channel.
struct Direction {
  int channel = 0;
  double seen = 0;              ///< over how well the best seen direction of its channel is
  std::vector<float> ofShots;   ///< U_m / s_m
  std::vector<float> ofLights;  ///< V_m
};

std::vector<Direction> directionsOf(const LightingMatrix& lighting, const LocalEvidenceTuning& tuning) {
  std::vector<Direction> all;
  for (int c = 0; c < 3; ++c) {
    const SingularValues svd = singularValues(lighting.matrix(c));
    // Not of the first: the light all together, which every model follows.
    for (int m = 1; m < int(svd.values.size()); ++m) {
      const double seen = svd.values[m] / std::max(svd.values[0], 1e-12);
      if (seen < tuning.leastSeen) break;
      Direction one{c, seen, {}, {}};
      for (int k = 0; k < lighting.shots; ++k) one.ofShots.push_back(float(svd.u(k, m) / svd.values[m]));
      for (int i = 0; i < lighting.lights; ++i) one.ofLights.push_back(float(svd.v(i, m)));
      all.push_back(std::move(one));
    }
  }
  return all;
}

SWAPLIGHT_SIMD(void, addShot,
               (const float* __restrict signal, float part, NoiseModel noise, float* __restrict misfit,
                float* __restrict variance, int count),
               (signal, part, noise, misfit, variance, count)) {
  for (int p = 0; p < count; ++p) {
    const float s = signal[p] > 0 ? signal[p] : 0;
    misfit[p] += part * signal[p];
    variance[p] += part * part * (noise.constant + s * (noise.linear + s * noise.square));
  }
}

SWAPLIGHT_SIMD(void, addScaled, (const float* __restrict from, float factor, float* __restrict to, int count),
               (from, factor, to, count)) {
  for (int p = 0; p < count; ++p) to[p] += factor * from[p];
}

SWAPLIGHT_SIMD(void, squareOf, (const float* __restrict from, float* __restrict to, int count),
               (from, to, count)) {
  for (int p = 0; p < count; ++p) to[p] = from[p] * from[p];
}

/// What is moved: w z in place of z, w in place of the misfit's mean square.
SWAPLIGHT_SIMD(void, weigh,
               (const float* __restrict noise, float kappa, float* __restrict square,
                float* __restrict misfit, int count),
               (noise, kappa, square, misfit, count)) {
  for (int p = 0; p < count; ++p) {
    const float floor = square[p] > 1e-20F ? square[p] : 1e-20F;
    const float left = 1 - kappa * noise[p] / floor;
    const float w = left > 0 ? left : 0;
    square[p] = w;
    misfit[p] *= w;
  }
}

SWAPLIGHT_SIMD(void, takeUp,
               (const float* __restrict weight, const float* __restrict noise, float lights,
                float* __restrict part, float* __restrict added, int count),
               (weight, noise, lights, part, added, count)) {
  for (int p = 0; p < count; ++p) {
    part[p] = weight[p] > part[p] ? weight[p] : part[p];
    added[p] += weight[p] * noise[p] / (9 * lights);  // of the mean of three channels
  }
}

/// Everything of one direction over the whole picture.
class DirectionPlanes {
 public:
  DirectionPlanes(int width, int height)
      : m_misfit(height, width, CV_32F), m_square(height, width, CV_32F), m_noise(height, width, CV_32F) {}

  /// z and its variance in `rows` rows from `top` on; flagged pixels show nothing.
  void fill(const Direction& direction, const NoiseModel& noise, const ShotSignal& signal,
            const SolvedSet& set, int top, int rows) {
    const size_t begin = size_t(top) * size_t(m_misfit.cols),
                 end = begin + size_t(rows) * size_t(m_misfit.cols);
    std::vector<float> scratch;
    for (size_t first = begin; first < end; first += kRun) {
      const int count = int(std::min<size_t>(kRun, end - first));
      PixelRun in;
      signal.run(first, count, false, scratch, in);
      float* misfit = plane(m_misfit) + first;
      float* variance = plane(m_noise) + first;
      std::fill_n(misfit, count, 0.0F);
      std::fill_n(variance, count, 0.0F);
      for (size_t k = 0; k < direction.ofShots.size(); ++k)
        addShot(in.signal[k][direction.channel], direction.ofShots[k], noise, misfit, variance, count);
      for (size_t i = 0; i < direction.ofLights.size(); ++i)
        addScaled(set.contributions[i].plane(direction.channel) + first, -direction.ofLights[i], misfit,
                  count);
      if (signal.flagged(first, count))
        for (int p = 0; p < count; ++p)
          if (signal.flags()[first + size_t(p)] != 0) misfit[p] = variance[p] = 0;
      squareOf(misfit, plane(m_square) + first, count);
    }
  }

  /// Of the windows whose first row is `top`: how far they would move, squared, and what noise alone would
  /// make of it.
  [[nodiscard]] std::array<double, 2> movedAndNoise(int top, int step, double kappa, int side) const {
    std::array<double, 2> sums{};
    for (int x = 0; x + side <= m_square.cols; x += step) {
      const cv::Rect window(x, top, side, side);
      const double d = cv::sum(m_square(window))[0], n = cv::sum(m_noise(window))[0];
      const double w = d > 0 ? std::max(0.0, 1 - kappa * n / d) : 0;
      sums[0] += w * w * d;
      sums[1] += n;
    }
    return sums;
  }

  /// Means over the windows.
  void average(int radius) {
    const cv::Size window(2 * radius + 1, 2 * radius + 1);
    for (cv::Mat* mat : {&m_square, &m_noise})
      cv::boxFilter(*mat, *mat, CV_32F, window, {-1, -1}, true, cv::BORDER_REPLICATE);
  }

  /// Moves the contributions; `part` and `added`: see takeUp.
  void move(const Direction& direction, float kappa, size_t first, int count, SolvedSet& set, float* part,
            float* added) {
    float* misfit = plane(m_misfit) + first;
    float* square = plane(m_square) + first;
    const float* noise = plane(m_noise) + first;
    weigh(noise, kappa, square, misfit, count);
    for (size_t i = 0; i < direction.ofLights.size(); ++i)
      addScaled(misfit, direction.ofLights[i], set.contributions[i].plane(direction.channel) + first, count);
    takeUp(square, noise, float(direction.ofLights.size()), part, added, count);
  }

 private:
  static float* plane(cv::Mat& mat) { return mat.ptr<float>(); }

  cv::Mat m_misfit, m_square, m_noise;
};

/// Contributions are no less than nothing; beta, sigma and model follow.
void finishRun(int lights, const float* part, const float* added, int count, float* model,
               const SolvedRun& out) {
  for (int i = 0; i < lights; ++i)
    for (int c = 0; c < 3; ++c)
      for (int p = 0; p < count; ++p) out.contribution[i][c][p] = std::max(out.contribution[i][c][p], 0.0F);
  writeBeta(lights, count, out);
  for (int p = 0; p < count; ++p) {
    if (part[p] <= 0) continue;
    model[p] = std::max(model[p], part[p]);
    float total = 0;
    for (int i = 0; i < lights; ++i)
      for (int c = 0; c < 3; ++c) total += out.contribution[i][c][p] / 3;
    if (total > 0) out.sigma[p] = std::sqrt(out.sigma[p] * out.sigma[p] + added[p] / (total * total));
  }
}

}  // namespace

void followLocalEvidence(const EstimatorContext& context, float colorUncertainty, const ShotSignal& signal,
                         const LocalEvidenceTuning& tuning, SolvedSet& set) {
  const int width = set.quality.width(), height = set.quality.height();
  const int side = 2 * tuning.radius + 1;
  if (std::min(width, height) < side) return;
  NoiseModel noise = context.noise;
  const float ofColors =
      colorUncertainty * colorUncertainty / (colorUncertainty + float(tuning.smallColorError));
  noise.square += ofColors * ofColors;
  const int bands = (height + kRowsTogether - 1) / kRowsTogether;
  const auto eachBand = [&](const auto& work) {
    parallelRows(bands, 1, [&](int begin, int end) {
      for (int band = begin; band < end; ++band) {
        const int top = band * kRowsTogether;
        work(top, std::min(kRowsTogether, height - top));
      }
    });
  };
  const auto eachRun = [&](const auto& work) {
    eachBand([&](int top, int rows) {
      const size_t end = size_t(top + rows) * size_t(width);
      for (size_t first = size_t(top) * size_t(width); first < end; first += kRun)
        work(first, int(std::min<size_t>(kRun, end - first)));
    });
  };

  DirectionPlanes planes(width, height);
  const int step = std::max(side, int(std::sqrt(double(width) * height / tuning.windows)));
  // Whether the set shows anything along a direction: by windows here and there.
  const auto shows = [&](const Direction& direction, double kappa) {
    std::vector<std::array<double, 2>> strips(size_t((height - side) / step + 1));
    parallelRows(int(strips.size()), 1, [&](int begin, int end) {
      for (int strip = begin; strip < end; ++strip) {
        planes.fill(direction, noise, signal, set, strip * step, side);
        strips[size_t(strip)] = planes.movedAndNoise(strip * step, step, kappa, side);
      }
    });
    std::array<double, 2> all{};
    for (const auto& [moved, ofNoise] : strips) all[0] += moved, all[1] += ofNoise;
    return all[0] > tuning.leastMoved * all[1];
  };
  std::vector<float> part, added;
  for (const Direction& direction : directionsOf(context.lighting, tuning)) {
    const double kappa = 1 + tuning.unknownNoise * (1 / direction.seen - 1);
    if (!shows(direction, kappa)) continue;
    eachBand([&](int top, int rows) { planes.fill(direction, noise, signal, set, top, rows); });
    planes.average(tuning.radius);
    part.resize(set.quality.pixelCount(), 0.0F);
    added.resize(set.quality.pixelCount(), 0.0F);
    eachRun([&](size_t first, int count) {
      planes.move(direction, float(kappa), first, count, set, &part[first], &added[first]);
    });
  }
  if (part.empty()) return;
  eachRun([&](size_t first, int count) {
    finishRun(context.lighting.lights, &part[first], &added[first], count, set.quality.plane(kModel) + first,
              runAt(set, first));
  });
}

}  // namespace swaplight
