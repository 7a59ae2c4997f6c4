#include "core/set/dynamic_range.h"

#include <fmt/core.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/quantile.h"
#include "core/ocio/color_config.h"
#include "core/ocio/luminance.h"

namespace swaplight {
namespace {

double percentile(std::vector<float>& values, double share) {
  return values.empty() ? 0 : quantile(std::span(values), share);
}

constexpr size_t kMostPixels = size_t{1} << 18;

/// The luminance of every `step`th pixel.
std::vector<float> luminanceOf(const Image& image, const Rgb& weights, size_t step) {
  std::vector<float> y;
  y.reserve(image.pixelCount() / step + 1);
  for (size_t p = 0; p < image.pixelCount(); p += step)
    y.push_back(weights.x * image.plane(0)[p] + weights.y * image.plane(1)[p] +
                weights.z * image.plane(2)[p]);
  return y;
}

void add(const std::vector<float>& more, std::vector<float>& sum) {
  for (size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
}

}  // namespace

std::vector<LightRange> dynamicRange(const SolvedSet& set) {
  if (set.quality.empty()) return {};
  const Rgb weights = luminanceWeights(set.colorSpace());
  // An odd step does not stay in the same columns.
  const size_t step = (set.quality.pixelCount() - 1) / kMostPixels | 1;
  std::vector<std::vector<float>> lights;
  for (const Image& light : set.contributions) lights.push_back(luminanceOf(light, weights, step));
  std::vector<float> sum =
      set.ambient ? luminanceOf(*set.ambient, weights, step) : std::vector<float>(lights.front().size());
  for (const std::vector<float>& light : lights) add(light, sum);
  std::vector<float> errors;
  for (size_t i = 0; i < sum.size(); ++i) {
    const float error = set.quality.plane(kSigma)[i * step] * sum[i];
    if (error > 0 && std::isfinite(error)) errors.push_back(error);
  }
  const double floor = percentile(errors, 0.1);
  std::vector<LightRange> ranges;
  for (size_t i = 0; i < lights.size(); ++i) {
    LightRange range{set.capture.lights.at(i).name, percentile(lights[i], 0.999), floor, 0};
    if (range.peak > 0 && floor > 0) range.stops = std::log2(range.peak / floor);
    ranges.push_back(range);
  }
  return ranges;
}

Json jsonFromRanges(const std::vector<LightRange>& ranges) {
  Json json = Json::array();
  for (const LightRange& range : ranges)
    json.push_back(
        {{"light", range.light}, {"peak", range.peak}, {"floor", range.floor}, {"stops", range.stops}});
  return json;
}

std::vector<LightRange> rangesFromJson(const Json& json, const std::string& where) {
  std::vector<LightRange> ranges;
  try {
    for (const Json& one : json)
      ranges.push_back({one.at("light").get<std::string>(), one.at("peak").get<double>(),
                        one.at("floor").get<double>(), one.at("stops").get<double>()});
  } catch (const Json::exception& error) {
    throw InputError("{}: is no list of the lights' ranges: {}", where, error.what());
  }
  return ranges;
}

std::string rangeWords(const LightRange& range) {
  return fmt::format("{:.1f} stops between the noise and its brightest parts", range.stops);
}

}  // namespace swaplight
