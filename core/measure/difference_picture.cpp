#include "core/measure/difference_picture.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/plot/color_map.h"
#include "core/plot/plot.h"
#include "core/plot/plot_canvas.h"

namespace swaplight {
namespace {

constexpr Rgb kNotFinite{1, 0, 1};
constexpr int kLegendWidth = 110;
constexpr int kLeastHeight = 140;  // room for the legend beside a tiny picture

double friendlyCeiling(double value) {
  if (!(value > 0)) return 1;
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1., 1.5, 2., 3., 4., 5., 6., 8.})
    if (value <= step * power * 1.0001) return step * power;
  return 10 * power;
}

cv::Scalar bytes(const Rgb& color) {
  return {std::round(color.r * 255.), std::round(color.g * 255.), std::round(color.b * 255.)};
}

void drawLegend(PlotCanvas& canvas, cv::Rect area, const AxisScale& scale) {
  const cv::Rect bar(area.x + 16, area.y + 32, 18, area.height - 48);
  canvas.text(scale.label, {bar.x + 0., area.y + 16.}, TextAnchor::Left, kTextHeight - 2);
  for (int y = 0; y < bar.height; ++y) {
    const auto t = static_cast<float>(1 - (y + .5) / bar.height);
    canvas.line({bar.x + 0., bar.y + y + .0}, {bar.br().x + 0., bar.y + y + .0}, bytes(viridis(t)));
  }
  for (const double tick : scale.ticks) {
    const double y = bar.br().y - scale.fraction(tick) * bar.height;
    canvas.line({bar.br().x + 0., y}, {bar.br().x + 5., y}, PlotCanvas::kInk);
    canvas.text(tickText(tick), {bar.br().x + 9., y}, TextAnchor::Left, kTextHeight - 2);
  }
}

}  // namespace

Image drawDifferenceMap(const Difference& difference, double maximum) {
  const ImageView map = difference.map.view();
  const Statistics& s = difference.statistics;
  const bool decibel = difference.metric == Metric::Psnr;
  const double low = decibel ? std::floor(s.min) : 0;
  const double high = maximum > low ? maximum : decibel ? std::ceil(s.max) : friendlyCeiling(s.p99);
  const AxisScale scale = scaleAxis({metricLabel(difference.metric), false, low, high}, {});

  PlotCanvas legend({kLegendWidth, std::max(map.height, kLeastHeight)});
  drawLegend(legend, legend.bounds(), scale);
  const Image side = legend.image();

  Image picture(ImageSpec{map.width + kLegendWidth, side.height(), {"R", "G", "B"}, "srgb"}, 1.f);
  const ImageSpan out = picture.span();
  parallelRows(map.height, 32, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < map.width; ++x) {
        const float value = map.at(0, x, y);
        const Rgb color =
            std::isfinite(value) ? viridis(static_cast<float>(scale.fraction(value))) : kNotFinite;
        for (int c = 0; c < 3; ++c) out.at(c, x, y) = color[c];
      }
  });
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < side.height(); ++y)
      std::copy_n(side.view().row(c, y), side.width(), out.row(c, y) + map.width);
  return picture;
}

Image drawDifferencePlot(const std::vector<PlottedDifferences>& parts) {
  constexpr int kColumn = 150, kAxis = 70, kLeast = 360, kMost = 6000;
  std::vector<BoxPlot> plots;
  for (size_t m = 0; m < parts.front().differences->size(); ++m) {
    BoxPlot& plot = plots.emplace_back();
    plot.value.label = metricLabel((*parts.front().differences)[m].metric);
    for (const PlottedDifferences& part : parts)
      plot.boxes.push_back({part.name, (*part.differences)[m].statistics});
  }
  const int width = int(plots.size()) * (kAxis + kColumn * int(parts.size()));
  return drawBoxPlots(plots, {std::clamp(width, kLeast, kMost), 520});
}

}  // namespace swaplight
