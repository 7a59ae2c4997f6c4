#include "core/plan/plan_forecast.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

constexpr int kForecastPixels = 1024;  // a few per cent
constexpr double kMostClipped = .02;
constexpr PlanNoise kNotApart{INFINITY, INFINITY};

bool isFinite(double value) {
  return std::isfinite(value);
}

}  // namespace

PlanForecast planForecast(const LightingMatrix& lighting, const SensorNoise& noise) {
  const std::vector<TypicalPixel> pixels = typicalPixels(lighting.lights, kForecastPixels);
  PlanForecast forecast{conditioningOf(lighting), kNotApart, kNotApart};
  const Conditioning& tells = forecast.conditioning;
  if (isFinite(tells.matteAmplification))
    forecast.matte = predictedNoise(lighting, noise, pixels, Model::Lambert);
  if (std::all_of(tells.amplification.begin(), tells.amplification.end(), isFinite))
    forecast.transport = predictedNoise(lighting, noise, pixels, Model::Transport);
  if (const double clipped = clippedFraction(lighting, pixels); clipped > kMostClipped)
    forecast.conditioning.advice.push_back(fmt::format(
        "{:.0f} % of typical pixels clip in a photograph: expose less, or dim the lights", 100 * clipped));
  return forecast;
}

}  // namespace swaplight
