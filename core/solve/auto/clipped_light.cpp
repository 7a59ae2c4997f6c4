#include "core/solve/auto/clipped_light.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "core/base/parallel.h"
#include "core/set/fill.h"
#include "core/solve/auto/separated_lights.h"

namespace swaplight {
namespace {

constexpr int kSweeps = 60;
constexpr double kSettled = 1e-5;  ///< of the light: change in a sweep

using Reading = ShotSignal::Reading;

/// A channel of a pixel: what the shots read there, and the neighbours' proportions.
class Channel {
 public:
  Channel(const EstimatorContext& context, int channel, const ClippedLightTuning& tuning,
          const std::vector<Reading>& readings, const std::vector<double>& proportions)
      : m_lighting(context.lighting),
        m_channel(channel),
        m_tuning(tuning),
        m_readings(readings),
        m_proportions(proportions),
        m_proportionsSquared(
            std::inner_product(proportions.begin(), proportions.end(), proportions.begin(), 0.0)) {
    for (const Reading& reading : readings) {
      const double part = tuning.modelError * double(reading.light);
      m_weights.push_back(1 / (double(context.noise.variance(reading.light)) + part * part + 1e-12));
    }
  }

  /// What the lights give. Empty where nothing is lit in this channel.
  [[nodiscard]] std::vector<double> light() const {
    const double start = scale();
    if (!(start > 0)) return {};
    std::vector<double> light;
    for (const double share : m_proportions) light.push_back(share * start);
    const double prior = 1 / std::pow(m_tuning.spread * start, 2);
    for (int sweep = 0; sweep < kSweeps; ++sweep)
      if (this->sweep(light, prior) < kSettled * start) break;
    return light;
  }

 private:
  [[nodiscard]] double color(size_t shot, int light) const {
    return double(m_lighting.color(int(shot), light)[m_channel]);
  }
  [[nodiscard]] double predicted(size_t shot, const std::vector<double>& light) const {
    double sum = 0;
    for (int i = 0; i < m_lighting.lights; ++i) sum += color(shot, i) * light[size_t(i)];
    return sum;
  }

  /// The light in the neighbours' proportions that the readings want.
  [[nodiscard]] double scale() const {
    double above = 0, below = 0, least = 0;
    for (size_t k = 0; k < m_readings.size(); ++k) {
      const double unit = predicted(k, m_proportions);
      if (!(unit > 0)) continue;
      if (m_readings[k].clipped) {
        least = std::max(least, double(m_readings[k].light) / unit);
      } else {
        above += m_weights[k] * unit * double(m_readings[k].light);
        below += m_weights[k] * unit * unit;
      }
    }
    return std::max(least, below > 0 ? above / below : 0);
  }

  /// Each light by itself, the others held. Returns the largest change.
  [[nodiscard]] double sweep(std::vector<double>& light, double prior) const {
    double changed = 0;
    for (int i = 0; i < m_lighting.lights; ++i) {
      const double share = m_proportions[size_t(i)];
      double along = 0;
      for (int j = 0; j < m_lighting.lights; ++j)
        if (j != i) along += m_proportions[size_t(j)] * light[size_t(j)];
      // |T - b (b T) / bb|^2 = |T|^2 - (b T)^2 / bb
      double curve = prior * (1 - share * share / m_proportionsSquared),
             wanted = prior * share * along / m_proportionsSquared;
      for (size_t k = 0; k < m_readings.size(); ++k) {
        const double own = color(k, i), all = predicted(k, light);
        if (m_readings[k].clipped && all >= double(m_readings[k].light)) continue;
        curve += m_weights[k] * own * own;
        wanted += m_weights[k] * own * (double(m_readings[k].light) - all + own * light[size_t(i)]);
      }
      if (!(curve > 0)) continue;
      const double now = std::max(wanted / curve, 0.0);
      changed = std::max(changed, std::abs(now - light[size_t(i)]));
      light[size_t(i)] = now;
    }
    return changed;
  }

  const LightingMatrix& m_lighting;
  int m_channel;
  const ClippedLightTuning& m_tuning;
  const std::vector<Reading>& m_readings;
  const std::vector<double>& m_proportions;
  double m_proportionsSquared;
  std::vector<double> m_weights;
};

/// The light of each of the set's lights, all channels together, with the marked pixels as their neighbours
/// have it: the bright ones, a highlight's shoulder, count more than the ground that it lies on.
Image neighboursLight(const SolvedSet& set, std::vector<uint8_t> unknown) {
  constexpr int kNoNeighbour = kTooDark | kMoved | kNotFinite | kFilled;
  for (size_t p = 0; p < unknown.size(); ++p)
    unknown[p] |= (int(set.quality.plane(kFlags)[p]) & kNoNeighbour) != 0;
  Image light(set.beta.spec(), 0);
  for (int i = 0; i < set.lightCount(); ++i)
    for (int c = 0; c < 3; ++c) {
      const float* contribution = set.contributions[size_t(i)].plane(c);
      std::transform(contribution, contribution + light.pixelCount(), light.plane(i), light.plane(i),
                     std::plus<>());
    }
  fillFromNeighbours(light, unknown);
  return light;
}

}  // namespace

size_t restoreClippedLight(const EstimatorContext& context, const ShotSignal& signal,
                           const ClippedLightTuning& tuning, SolvedSet& set) {
  const float separated = separatedPart(context.lighting);
  if (separated >= 1) return 0;
  std::vector<uint8_t> clipped = signal.undetermined();
  std::vector<size_t> pixels;
  for (size_t p = 0; p < clipped.size(); ++p)
    if (clipped[p]) pixels.push_back(p);
  if (pixels.empty()) return 0;
  const int lights = context.lighting.lights, shots = context.lighting.shots;
  const Image around = neighboursLight(set, std::move(clipped));
  parallelRows(int(pixels.size()), 64, [&](int begin, int end) {
    std::vector<double> proportions(static_cast<size_t>(lights));
    std::vector<Reading> readings(static_cast<size_t>(shots));
    for (int each = begin; each < end; ++each) {
      const size_t p = pixels[size_t(each)];
      double sum = 0;
      for (int i = 0; i < lights; ++i) sum += proportions[size_t(i)] = around.plane(i)[p];
      if (!(sum > 0)) continue;  // nothing is known around it
      for (double& share : proportions) share /= sum;
      for (int c = 0; c < 3; ++c) {
        for (int k = 0; k < shots; ++k) readings[size_t(k)] = signal.reading(p, k, c);
        const std::vector<double> light = Channel(context, c, tuning, readings, proportions).light();
        for (int i = 0; i < lights && !light.empty(); ++i) {
          float& contribution = set.contributions[size_t(i)].plane(c)[p];
          contribution = std::lerp(float(light[size_t(i)]), contribution, separated);
        }
      }
      float& flags = set.quality.plane(kFlags)[p];
      flags = float(int(flags) | kFilled);
      float& sigma = set.quality.plane(kSigma)[p];
      sigma = std::max(sigma, float(tuning.spread));
    }
  });
  return pixels.size();
}

}  // namespace swaplight
