#include "core/solve/signal_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr float kDarkest = 1e-4F, kBrightest = 1e6F;  // half a decade within what was measured to solve well
constexpr float kLeastLight = 1e-30F, kMostLight = 1e22F;
constexpr size_t kSample = 100000;
constexpr double kLevel = 0.95;  // hot pixels are fewer
constexpr int kGrain = 1 << 16;

/// 0 where all is black or broken.
float levelOf(const CapturePixels& pixels) {
  std::vector<float> values;
  for (const Image& shot : pixels.shots)
    for (int c = 0; c < shot.channelCount(); ++c)
      for (size_t p = 0; p < shot.pixelCount(); p += 1 + shot.pixelCount() / kSample)
        if (const float value = std::abs(shot.plane(c)[p]); value > 0 && std::isfinite(value))
          values.push_back(value);
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<ptrdiff_t>(kLevel * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Finite values stay finite.
void multiply(Image& image, float factor) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  for (int c = 0; c < image.channelCount(); ++c)
    parallelRows(static_cast<int>((image.pixelCount() + kGrain - 1) / kGrain), 1, [&](int begin, int end) {
      const size_t last = std::min(image.pixelCount(), static_cast<size_t>(end) * kGrain);
      for (size_t p = static_cast<size_t>(begin) * kGrain; p < last; ++p) {
        float& value = image.plane(c)[p];
        if (std::isfinite(value)) value = std::clamp(value * factor, -kLargest, kLargest);
      }
    });
}

}  // namespace

float signalScale(const CapturePixels& pixels, const std::string& where) {
  const float level = levelOf(pixels);
  if (level == 0 || (level >= kDarkest && level <= kBrightest)) return 1;
  if (level < kLeastLight || level > kMostLight)
    throw InputError(
        "{}: the pictures' values lie around {:.0e}, which is no light: expected about 0 to 1. "
        "Export the shots again.",
        where, level);
  return std::exp2(-std::round(std::log2(level)));
}

CapturePixels scaledSignal(const CapturePixels& pixels, float scale) {
  CapturePixels scaled = withoutShots(pixels);
  for (const Image& shot : pixels.shots) multiply(scaled.shots.emplace_back(shot.clone()), scale);
  if (scaled.ambient) multiply(*scaled.ambient, scale);
  for (float& clip : scaled.clipLevel) clip *= scale;
  for (float& step : scaled.quantum) step *= scale;
  for (ValueVariance& at : scaled.rounding) at.value *= scale;  // its variance is over that of the last step
  for (ValueVariance& at : scaled.codingError) at = {at.value * scale, at.variance * scale * scale};
  return scaled;
}

// variance = y / fullWell + read^2, both sides in units of full scale.
SensorNoise scaledNoise(const SensorNoise& noise, float scale) {
  return {noise.read * double{scale}, noise.fullWell / double{scale}};
}

void unscale(SolvedSet& set, float scale) {
  const float back = 1 / scale;
  for (Image& contribution : set.contributions) multiply(contribution, back);
  for (Image& highlight : set.highlights) multiply(highlight, back);
  if (set.ambient) multiply(*set.ambient, back);
}

}  // namespace swaplight
