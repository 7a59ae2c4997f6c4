#include "core/solve/highlights/light_saturation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swaplight {
namespace {

/// quality.sigma is of the channels' mean, averaged over the lights; a channel of one light is off by more.
/// Measured on captures/gloss: 0.8 to 1.8 times sigma.
constexpr float kChannelError = 1.5F;

}  // namespace

float LightSaturation::of(int light) const {
  const auto i = static_cast<size_t>(light);
  return mean[i] > 0 ? color[i] / mean[i] : 0;
}

float LightSaturation::errorOf(int light) const {
  const float seen = mean[static_cast<size_t>(light)];
  return seen > 0 ? error / seen : std::numeric_limits<float>::infinity();
}

float LightSaturation::surest(float sure) const {
  float most = 0;
  for (int i = 0; i < lights; ++i) most = std::max(most, of(i) - sure * errorOf(i));
  return most;
}

LightSaturation saturationAt(const SolvedSet& set, size_t p, float leastError) {
  LightSaturation pixel;
  pixel.lights = set.lightCount();
  float sum = 0;
  for (size_t i = 0; i < set.contributions.size(); ++i) {
    const Image& light = set.contributions[i];
    const float r = light.plane(0)[p], g = light.plane(1)[p], b = light.plane(2)[p];
    const float mean = (r + g + b) / 3;
    pixel.mean[i] = mean;
    pixel.color[i] = std::sqrt((r - mean) * (r - mean) + (g - mean) * (g - mean) + (b - mean) * (b - mean));
    pixel.least[i] = std::min({r, g, b});
    sum += mean;
  }
  pixel.error = std::max(kChannelError * set.quality.plane(kSigma)[p] * sum, leastError);
  return pixel;
}

}  // namespace swaplight
