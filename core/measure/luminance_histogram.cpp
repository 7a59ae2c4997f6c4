#include "core/measure/luminance_histogram.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/json.h"
#include "core/base/quantile.h"
#include "core/ocio/color_config.h"
#include "core/ocio/luminance.h"

namespace swaplight {
namespace {

constexpr double kMiddleGrey = 0.18;
constexpr double kBinsAStop = 4;

}  // namespace

LuminanceHistogram luminanceHistogram(const Image& picture) {
  const Rgb weights = luminanceWeights(picture.spec().colorSpace);
  LuminanceHistogram histogram;
  histogram.share.assign(static_cast<size_t>((histogram.high - histogram.low) * kBinsAStop), 0);
  std::vector<float> lit;
  const auto luminance = [&](size_t p) {
    return weights.x * picture.plane(0)[p] + weights.y * picture.plane(1)[p] +
           weights.z * picture.plane(2)[p];
  };
  size_t known = 0;
  for (size_t p = 0; p < picture.pixelCount(); ++p) known += !std::isnan(luminance(p));
  const double each = 1.0 / static_cast<double>(std::max<size_t>(known, 1));
  for (size_t p = 0; p < picture.pixelCount(); ++p) {
    const float y = luminance(p);
    if (std::isnan(y)) continue;
    const double stops = y > 0 ? std::log2(y / kMiddleGrey) : -INFINITY;
    if (y > 0) lit.push_back(static_cast<float>(stops));
    if (!(stops >= histogram.low))
      histogram.black += each;
    else if (stops >= histogram.high)
      histogram.bright += each;
    else
      histogram.share[static_cast<size_t>((stops - histogram.low) * kBinsAStop)] += each;
  }
  if (!lit.empty()) histogram.median = median(std::span(lit));
  return histogram;
}

Json jsonFromHistogram(const LuminanceHistogram& histogram) {
  return {{"median_stops", histogram.median}, {"low", histogram.low},      {"high", histogram.high},
          {"below", histogram.black},         {"above", histogram.bright}, {"share", histogram.share}};
}

Image drawLuminanceHistograms(const std::vector<NamedHistogram>& histograms, PlotSize size) {
  ScatterPlot plot;
  plot.title = "Luminance";
  plot.x = {"stops from middle grey (0.18)", false, {}, {}};
  plot.y = {"% of the pixels in a quarter of a stop", false, 0, {}};
  for (const NamedHistogram& named : histograms) {
    const LuminanceHistogram& h = named.histogram;
    ScatterPlot::Series series;
    series.name = fmt::format("{} (median {:+.1f})", named.name, h.median);
    series.style = ScatterPlot::Style::Steps;
    for (size_t i = 0; i <= h.share.size(); ++i) {
      series.x.push_back(h.low + static_cast<double>(i) / kBinsAStop);
      series.y.push_back(i < h.share.size() ? 100 * h.share[i] : 0);
    }
    plot.series.push_back(std::move(series));
  }
  return drawScatterPlot(plot, size);
}

}  // namespace swaplight
