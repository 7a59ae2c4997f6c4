#include "core/solve/auto/clipped_light.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/base/parallel.h"
#include "core/set/fill.h"
#include "core/solve/auto/censored_light.h"
#include "core/solve/auto/separated_lights.h"

namespace swaplight {
namespace {

constexpr double kSettled = 1e-5;  ///< of the light: change in a sweep

using Reading = ShotSignal::Reading;

/// What the lights give in a channel of a pixel whose neighbours have such proportions. Empty where nothing
/// is lit in it.
std::vector<double> lightOf(const CensoredLight& channel, const std::vector<double>& proportions,
                            double spread) {
  const double start = channel.scale(proportions);
  if (!(start > 0)) return {};
  std::vector<double> light;
  for (const double share : proportions) light.push_back(share * start);
  channel.descend(light, {proportions, 1 / std::pow(spread * start, 2)}, kSettled * start);
  return light;
}

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
        const CensoredLight channel(context, c, readings, tuning.modelError);
        const std::vector<double> light = lightOf(channel, proportions, tuning.spread);
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
