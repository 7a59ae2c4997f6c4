#include "core/measure/dynamic_range.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/color/color_config.h"
#include "core/view/luminance.h"

namespace swaplight {
namespace {

double percentile(std::vector<float>& values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<float> luminanceOf(const Image& image, const Rgb& weights) {
  std::vector<float> y(image.pixelCount());
  for (size_t p = 0; p < y.size(); ++p)
    y[p] = weights.x * image.plane(0)[p] + weights.y * image.plane(1)[p] + weights.z * image.plane(2)[p];
  return y;
}

}  // namespace

std::vector<LightRange> dynamicRange(const SolvedSet& set) {
  if (set.quality.empty()) return {};
  const Rgb weights = luminanceWeights(ColorConfig::current(), set.colorSpace());
  const std::vector<float> sum = luminanceOf(allWhite(set), weights);
  std::vector<float> errors;
  for (size_t p = 0; p < sum.size(); ++p) {
    const float error = set.quality.plane(kSigma)[p] * sum[p];
    if (error > 0 && std::isfinite(error)) errors.push_back(error);
  }
  const double floor = percentile(errors, 0.1);
  std::vector<LightRange> ranges;
  for (size_t i = 0; i < set.contributions.size(); ++i) {
    std::vector<float> own = luminanceOf(set.contributions[i], weights);
    LightRange range{set.capture.lights.at(i).name, percentile(own, 0.999), floor, 0};
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

std::string rangeWords(const LightRange& range) {
  return fmt::format("{:.1f} stops between the noise and its brightest parts", range.stops);
}

}  // namespace swaplight
