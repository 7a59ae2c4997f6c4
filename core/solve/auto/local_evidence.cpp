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

constexpr float kLeastVariance = 1e-20F;  // of a pixel that is flagged
constexpr float kMostMisfit = 25;         // times its variance a pixel's square counts at most

/// A direction of the contributions of a channel.
struct Direction {
  int channel = 0;
  bool first = false;           ///< the light all together, which every model follows: no evidence
  double kappa = 1;             ///< of its noise
  std::vector<float> ofShots;   ///< U_m / s_m
  std::vector<float> ofLights;  ///< V_m
};

/// All of them; none where one is hardly seen.
std::vector<Direction> directionsOf(const LightingMatrix& lighting, const LocalEvidenceTuning& tuning) {
  std::vector<Direction> all;
  for (int c = 0; c < 3; ++c) {
    const SingularValues svd = singularValues(lighting.matrix(c));
    for (int m = 0; m < lighting.lights; ++m) {
      const double seen = m < int(svd.values.size()) ? svd.values[m] / std::max(svd.values[0], 1e-12) : 0;
      if (seen < tuning.leastSeen) return {};
      Direction one{c, m == 0, tuning.unknownNoise * (1 + tuning.unknownWeak * (1 / seen - 1)), {}, {}};
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

/// The misfit's square over its variance; a broken pixel is no evidence of its surroundings.
SWAPLIGHT_SIMD(void, overVariance, (const float* __restrict variance, float* __restrict misfit, int count),
               (variance, misfit, count)) {
  for (int p = 0; p < count; ++p) {
    const float floor = variance[p] > kLeastVariance ? variance[p] : kLeastVariance;
    const float ratio = misfit[p] * misfit[p] / floor;
    misfit[p] = ratio < kMostMisfit ? ratio : kMostMisfit;
  }
}

SWAPLIGHT_SIMD(void, multiply, (const float* __restrict factor, float* __restrict values, int count),
               (factor, values, count)) {
  for (int p = 0; p < count; ++p) values[p] *= factor[p];
}

/// The largest weight of a channel.
SWAPLIGHT_SIMD(void, takeWeight,
               (const float* __restrict ratio, float expected, float all, float* __restrict weight,
                int count),
               (ratio, expected, all, weight, count)) {
  for (int p = 0; p < count; ++p) {
    const float one = ratio[p] > expected ? (1 - expected / ratio[p]) / all : 0;
    weight[p] = one > weight[p] ? one : weight[p];
  }
}

/// What the photographs show and the answer does not.
class LocalEvidence {
 public:
  LocalEvidence(const EstimatorContext& context, const ShotSignal& signal, const LocalEvidenceTuning& tuning,
                SolvedSet& set)
      : m_noise(context.noise),
        m_signal(signal),
        m_tuning(tuning),
        m_set(set),
        m_directions(directionsOf(context.lighting, tuning)),
        m_width(set.quality.width()),
        m_height(set.quality.height()) {
    for (const Direction& one : m_directions)
      if (!one.first) m_expected[size_t(one.channel)] += float(one.kappa);
  }

  /// Whether the whole set shows anything: by windows here and there.
  [[nodiscard]] bool any() const {
    const int side = 2 * m_tuning.radius + 1;
    if (m_set.contributions.size() < 2 || m_directions.empty() || std::min(m_width, m_height) < side)
      return false;
    const int step = std::max(side, int(std::sqrt(double(m_width) * m_height / m_tuning.windows)));
    std::vector<std::array<double, 2>> strips(size_t((m_height - side) / step + 1));
    parallelEach(int(strips.size()),
                 [&](int strip) { strips[size_t(strip)] = movedAndWindows(strip * step, step, side); });
    double moved = 0, windows = 0;
    for (const auto& [ofStrip, count] : strips) moved += ofStrip, windows += count;
    return moved > m_tuning.leastMoved * windows;
  }

  /// Moves the contributions.
  void follow() {
    cv::Mat weight(m_height, m_width, CV_32F, cv::Scalar(0));
    for (int c = 0; c < 3; ++c) {
      const cv::Mat ratio = ratioOf(c);
      eachRun([&](size_t first, int count) {
        takeWeight(ratio.ptr<float>() + first, m_expected[size_t(c)], allOf(c), weight.ptr<float>() + first,
                   count);
      });
    }
    eachRun([&](size_t first, int count) { move(first, count, weight.ptr<float>() + first); });
  }

 private:
  /// What the photographs show over what noise makes of it, summed over a channel's directions.
  [[nodiscard]] cv::Mat ratioOf(int channel) const {
    cv::Mat ratio(m_height, m_width, CV_32F, cv::Scalar(0));
    eachRun([&](size_t first, int count) {
      std::array<float, kRun> own{};
      for (const Direction& direction : m_directions)
        if (!direction.first && direction.channel == channel) {
          ratioOf(direction, first, count, own.data());
          addScaled(own.data(), 1, ratio.ptr<float>() + first, count);
        }
    });
    const cv::Size window(2 * m_tuning.radius + 1, 2 * m_tuning.radius + 1);
    cv::boxFilter(ratio, ratio, CV_32F, window, {-1, -1}, true, cv::BORDER_REPLICATE);
    return ratio;
  }

  /// Of every pixel alone, for one direction.
  void ratioOf(const Direction& direction, size_t first, int count, float* ratio) const {
    std::array<float, kRun> variance;
    for (int begin = 0; begin < count; begin += kRun) {
      const int part = std::min(kRun, count - begin);
      misfitOf(direction, first + size_t(begin), part, ratio + begin, variance.data());
      overVariance(variance.data(), ratio + begin, part);
    }
  }

  /// z and its variance; flagged pixels show nothing.
  void misfitOf(const Direction& direction, size_t first, int count, float* misfit, float* variance) const {
    std::vector<float> scratch;
    PixelRun in;
    m_signal.run(first, count, false, scratch, in);
    std::fill_n(misfit, count, 0.0F);
    std::fill_n(variance, count, 0.0F);
    for (size_t k = 0; k < direction.ofShots.size(); ++k)
      addShot(in.signal[k][direction.channel], direction.ofShots[k], m_noise, misfit, variance, count);
    for (size_t i = 0; i < direction.ofLights.size(); ++i)
      addScaled(m_set.contributions[i].plane(direction.channel) + first, -direction.ofLights[i], misfit,
                count);
    const bool flagged = m_signal.flagged(first, count);
    if (!flagged) return;
    for (int p = 0; p < count; ++p)
      if (m_signal.flags()[first + size_t(p)] != 0) misfit[p] = variance[p] = 0;
  }

  /// What is left of a weight where every pixel's misfit is as large as it may count.
  [[nodiscard]] float allOf(int channel) const {
    return 1 - m_expected[size_t(channel)] / (kMostMisfit * float(m_set.contributions.size() - 1));
  }

  /// Of the windows whose first row is `top`: how far they would move, squared, over what noise makes of it;
  /// and how many they are.
  [[nodiscard]] std::array<double, 2> movedAndWindows(int top, int step, int side) const {
    cv::Mat pixels(side, m_width, CV_32F);
    std::vector<std::array<double, 3>> ratios(size_t((m_width - side) / step + 1));
    for (const Direction& direction : m_directions) {
      if (direction.first) continue;
      for (int y = 0; y < side; ++y)
        ratioOf(direction, size_t(top + y) * size_t(m_width), m_width, pixels.ptr<float>(y));
      for (size_t j = 0; j < ratios.size(); ++j)
        ratios[j][size_t(direction.channel)] += cv::mean(pixels(cv::Rect(int(j) * step, 0, side, side)))[0];
    }
    double moved = 0;
    for (const auto& channels : ratios) {
      double most = 0;
      for (size_t c = 0; c < 3; ++c) {
        const double expected = m_expected[c], w = std::max(0.0, 1 - expected / std::max(channels[c], 1e-9));
        most = std::max(most, w * w * channels[c] / expected);
      }
      moved += most;
    }
    return {moved, double(ratios.size())};
  }

  /// By this part of the way to the full demultiplex.
  void move(size_t first, int count, float* weight) {
    if (m_signal.flagged(first, count))
      for (int p = 0; p < count; ++p)
        if (m_signal.flags()[first + size_t(p)] != 0) weight[p] = 0;
    std::array<float, kRun> misfit{}, variance{}, added{};
    const SolvedRun out = runAt(m_set, first);
    const int lights = int(m_set.contributions.size());
    for (const Direction& direction : m_directions) {
      misfitOf(direction, first, count, misfit.data(), variance.data());
      multiply(weight, misfit.data(), count);
      multiply(weight, variance.data(), count);
      for (int i = 0; i < lights; ++i)
        addScaled(misfit.data(), direction.ofLights[size_t(i)], out.contribution[i][direction.channel],
                  count);
      addScaled(variance.data(), 1 / float(9 * lights), added.data(),
                count);  // of the mean of three channels
    }
    finish(lights, weight, added.data(), count, m_set.quality.plane(kModel) + first, out);
  }

  /// Contributions are no less than nothing; beta, sigma and model follow.
  static void finish(int lights, const float* weight, const float* added, int count, float* model,
                     const SolvedRun& out) {
    for (int i = 0; i < lights; ++i)
      for (int c = 0; c < 3; ++c)
        for (int p = 0; p < count; ++p) out.contribution[i][c][p] = std::max(out.contribution[i][c][p], 0.0F);
    writeBeta(lights, count, out);
    for (int p = 0; p < count; ++p) {
      if (weight[p] <= 0) continue;
      model[p] = std::max(model[p], weight[p]);
      float total = 0;
      for (int i = 0; i < lights; ++i)
        for (int c = 0; c < 3; ++c) total += out.contribution[i][c][p] / 3;
      if (total > 0) out.sigma[p] = std::sqrt(out.sigma[p] * out.sigma[p] + added[p] / (total * total));
    }
  }

  template <typename Work>
  void eachRun(const Work& work) const {
    const size_t pixels = size_t(m_width) * size_t(m_height);
    parallelRows(int((pixels + kRun - 1) / kRun), 4, [&](int begin, int end) {
      for (int run = begin; run < end; ++run) {
        const size_t first = size_t(run) * kRun;
        work(first, int(std::min<size_t>(kRun, pixels - first)));
      }
    });
  }

  NoiseModel m_noise;
  const ShotSignal& m_signal;
  const LocalEvidenceTuning& m_tuning;
  SolvedSet& m_set;
  std::vector<Direction> m_directions;
  int m_width, m_height;
  std::array<float, 3> m_expected{};  ///< of a channel: the sum of the ratios that noise makes, or more
};

}  // namespace

void followLocalEvidence(const EstimatorContext& context, float colorUncertainty, const ShotSignal& signal,
                         const LocalEvidenceTuning& tuning, SolvedSet& set) {
  EstimatorContext noisy = context;
  const float ofColors =
      colorUncertainty * colorUncertainty / (colorUncertainty + float(tuning.smallColorError));
  noisy.noise.square += ofColors * ofColors;
  LocalEvidence evidence(noisy, signal, tuning, set);
  if (evidence.any()) evidence.follow();
}

}  // namespace swaplight
