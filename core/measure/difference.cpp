#include "core/measure/difference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <sstream>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/color/srgb.h"
#include "core/measure/delta_e.h"

namespace swaplight {
namespace {

struct MetricNames {
  Metric metric;
  const char* name;
  const char* label;
};
constexpr MetricNames kMetrics[] = {{Metric::DeltaE2000, "de2000",
                                     "\xce\x94"
                                     "E00"},
                                    {Metric::AbsDiff, "absdiff", "absolute difference"},
                                    {Metric::Rmse, "rmse", "RMSE"},
                                    {Metric::Psnr, "psnr", "PSNR (dB)"}};

double psnr(double peak, double rmse) {
  return rmse > 0 ? std::min(20 * std::log10(peak / rmse), kLargestPsnr) : kLargestPsnr;
}

// Fills `out` with the mean over the channels of valueOf(difference), put through `end`, for each pixel.
template <typename ValueOf, typename End>
void mapDifferences(const PicturePair& pair, float* out, const ValueOf& valueOf, const End& endOf) {
  const int width = pair.test.width();
  const int channels = pair.test.channelCount();
  parallelRows(pair.test.height(), 32, [&](int begin, int end) {
    const ptrdiff_t last = static_cast<ptrdiff_t>(end) * width;
    for (ptrdiff_t p = static_cast<ptrdiff_t>(begin) * width; p < last; ++p) {
      double sum = 0;
      for (int c = 0; c < channels; ++c)
        sum += valueOf(static_cast<double>(pair.test.plane(c)[p]) - pair.reference.plane(c)[p]);
      out[p] = std::isfinite(sum) ? static_cast<float>(endOf(sum / channels))
                                  : std::numeric_limits<float>::quiet_NaN();
    }
  });
}

// A picture as linear light, which CIEDE2000 starts from.
Image linearOf(const Image& image, bool encoded) {
  Image linear = image.clone();
  if (encoded) linearize(linear);
  return linear;
}

}  // namespace

std::string metricName(Metric metric) {
  return kMetrics[static_cast<size_t>(metric)].name;
}

std::string metricLabel(Metric metric) {
  return kMetrics[static_cast<size_t>(metric)].label;
}

std::vector<Metric> metricsFromNames(const std::string& names) {
  std::vector<Metric> metrics;
  std::stringstream list(names);
  for (std::string name; std::getline(list, name, ',');) {
    const auto* found =
        std::find_if(std::begin(kMetrics), std::end(kMetrics), [&](const auto& m) { return name == m.name; });
    if (found == std::end(kMetrics))
      throw InputError("unknown metric \"{}\": give de2000, absdiff, rmse or psnr, joined by commas", name);
    if (std::find(metrics.begin(), metrics.end(), found->metric) == metrics.end())
      metrics.push_back(found->metric);
  }
  if (metrics.empty())
    throw InputError("no metric was named: give de2000, absdiff, rmse or psnr, joined by commas");
  return metrics;
}

void linearize(Image& image) {
  for (int c = 0; c < image.channelCount(); ++c)
    for (float& v : std::span(image.plane(c), image.pixelCount())) v = linearFromSrgb(v);
}

float displayScale(ImageView reference) {
  std::vector<float> values;
  values.reserve(static_cast<size_t>(reference.width) * reference.height * 3);
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < reference.height; ++y)
      std::copy_if(reference.row(c, y), reference.row(c, y) + reference.width, std::back_inserter(values),
                   [](float v) { return std::isfinite(v); });
  if (values.empty()) return 1;
  const double bright = interpolatedQuantile(std::span(values), .995);
  return bright > 0 ? static_cast<float>(.9 / bright) : 1;
}

Difference difference(const PicturePair& pair, Metric metric, const DifferenceOptions& options) {
  const Image& test = pair.test;
  Difference result{
      metric, Image(ImageSpec{test.width(), test.height(), {metricName(metric)}, "data"}), {}, 0};
  float* map = result.map.plane(0);
  const double peak = pair.encoded ? 1 : 1. / pair.scale;
  switch (metric) {
    case Metric::DeltaE2000:
      deltaE2000(linearOf(test, pair.encoded).view(), linearOf(pair.reference, pair.encoded).view(),
                 pair.scale, result.map.span(), options.weights);
      break;
    case Metric::AbsDiff:
      mapDifferences(
          pair, map, [](double d) { return std::abs(d); }, [](double mean) { return mean; });
      break;
    case Metric::Rmse:
    case Metric::Psnr:
      mapDifferences(
          pair, map, [](double d) { return d * d; }, [](double mean) { return std::sqrt(mean); });
      break;
  }

  const size_t pixels = result.map.pixelCount();
  double squares = 0;
  if (metric == Metric::Rmse || metric == Metric::Psnr)
    for (const float v : std::span(map, pixels)) squares += std::isfinite(v) ? double{v} * v : 0;
  if (metric == Metric::Psnr)
    for (float& v : std::span(map, pixels)) v = std::isfinite(v) ? static_cast<float>(psnr(peak, v)) : v;

  result.statistics = statisticsOf({map, map + pixels});
  const size_t count = result.statistics.count;
  if (count == 0) throw InputError("no pixel is finite in both pictures: there is nothing to compare");
  const double rmse = std::sqrt(squares / static_cast<double>(count));
  result.value = metric == Metric::Rmse   ? rmse
                 : metric == Metric::Psnr ? psnr(peak, rmse)
                                          : result.statistics.mean;
  if (options.threshold && metric != Metric::Psnr) {
    const auto above = std::count_if(map, map + pixels, [&](float v) { return v > *options.threshold; });
    result.shareAbove = static_cast<double>(above) / static_cast<double>(count);
  }
  return result;
}

}  // namespace swaplight
