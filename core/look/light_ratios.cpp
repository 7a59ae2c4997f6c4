#include "core/look/light_ratios.h"

#include <algorithm>
#include <cmath>

#include "core/base/quantile.h"
#include "core/ocio/luminance.h"

namespace swaplight {
namespace {

constexpr size_t kMostPixels = 100000;
constexpr size_t kFewPixels = 64;     ///< fewer in common say nothing
constexpr float kBrightPart = 0.95F;  ///< the quantile of a light that its reach is measured by
constexpr float kReach = 1.0F / 8;

/// The luminance of each light at evenly spread pixels that can be trusted: [pixel * lights + light].
std::vector<float> sampledLuminances(const SolvedSet& set) {
  const Rgb weights = luminanceWeights(set.colorSpace());
  const size_t pixels = set.beta.pixelCount();
  const size_t step = std::max<size_t>(1, pixels / kMostPixels);
  const bool hasFlags = set.quality.pixelCount() == pixels && set.quality.channelCount() > kFlags;
  std::vector<float> luminances;
  for (size_t p = 0; p < pixels; p += step) {
    const int flags = hasFlags ? static_cast<int>(set.quality.plane(kFlags)[p]) : 0;
    if ((flags & (kTooDark | kNotFinite | kFilled)) != 0) continue;
    for (const Image& light : set.contributions)
      luminances.push_back(weights.r * light.plane(0)[p] + weights.g * light.plane(1)[p] +
                           weights.b * light.plane(2)[p]);
  }
  return luminances;
}

}  // namespace

LightRatios::LightRatios(const SolvedSet& set)
    : m_lights(set.contributions.size()), m_stops(m_lights * m_lights, 0) {
  const std::vector<float> luminances = sampledLuminances(set);
  const size_t pixels = luminances.size() / std::max<size_t>(1, m_lights);
  std::vector<float> sums(m_lights, 0);
  std::vector<float> reach(m_lights, 0);
  std::vector<float> values(pixels);
  for (size_t i = 0; i < m_lights; ++i) {
    for (size_t p = 0; p < pixels; ++p) sums[i] += values[p] = luminances[p * m_lights + i];
    if (pixels > 0) reach[i] = kReach * quantile(std::span(values), kBrightPart);
  }
  std::vector<float> ratios;
  for (size_t a = 0; a < m_lights; ++a)
    for (size_t b = a + 1; b < m_lights; ++b) {
      ratios.clear();
      for (size_t p = 0; p < pixels; ++p) {
        const float of = luminances[p * m_lights + a], over = luminances[p * m_lights + b];
        if (of > 0 && of >= reach[a] && over > 0 && over >= reach[b]) ratios.push_back(std::log2(of / over));
      }
      float stops = 0;
      if (ratios.size() >= std::max(kFewPixels, pixels / 1000))
        stops = median(std::span(ratios));
      else if (sums[a] > 0 && sums[b] > 0)
        stops = std::log2(sums[a] / sums[b]);
      m_stops[a * m_lights + b] = stops;
      m_stops[b * m_lights + a] = -stops;
    }
}

float LightRatios::stops(size_t light, size_t other) const {
  return light < m_lights && other < m_lights ? m_stops[light * m_lights + other] : 0;
}

}  // namespace swaplight
