#include <fmt/format.h>

#include <algorithm>

#include "core/plot/plot_canvas.h"

namespace swaplight {
namespace {

constexpr double kLinesBelow = 6.5;  // of text, a box's name and figures

void drawBoxes(PlotCanvas& canvas, cv::Rect outer, const BoxPlot& plot) {
  std::vector<double> values;
  for (const BoxPlot::Box& box : plot.boxes) {
    const Statistics& s = box.statistics;
    values.insert(values.end(), {s.whiskerLow, s.whiskerHigh, s.mean, s.p95});
  }
  const AxisScale scale = scaleAxis(plot.value, values);
  const PlotFrame frame(canvas, outer, plot.title, nullptr, scale, kTextHeight * kLinesBelow);
  const double column = static_cast<double>(frame.inner().width) / static_cast<double>(plot.boxes.size());
  const double half = std::min(column * .28, 60.);

  for (size_t i = 0; i < plot.boxes.size(); ++i) {
    const Statistics& s = plot.boxes[i].statistics;
    const double x = frame.inner().x + (static_cast<double>(i) + .5) * column;
    const cv::Scalar color = PlotCanvas::seriesColor(i);
    const auto level = [&](double value, double width, const cv::Scalar& ink, int thickness) {
      canvas.line({x - width, frame.yPixel(value)}, {x + width, frame.yPixel(value)}, ink, thickness);
    };

    // Whiskers, box, median, 95th percentile, mean.
    canvas.line({x, frame.yPixel(s.whiskerLow)}, {x, frame.yPixel(s.whiskerHigh)}, PlotCanvas::kInk);
    level(s.whiskerLow, half * .5, PlotCanvas::kInk, 1);
    level(s.whiskerHigh, half * .5, PlotCanvas::kInk, 1);
    const cv::Scalar pale = color * .35 + cv::Scalar::all(255 * .65);
    canvas.rectangle({x - half, frame.yPixel(s.q3), 2 * half, frame.yPixel(s.q1) - frame.yPixel(s.q3)}, pale,
                     color);
    level(s.median, half, PlotCanvas::kInk, 2);
    level(s.p95, half * .25, color, 2);
    canvas.diamond({x, frame.yPixel(s.mean)}, 5, color);

    // Names and numbers below.
    const double bottom = frame.inner().br().y;
    const std::vector<std::string> lines = {
        plot.boxes[i].name, fmt::format("median {:.3g}", s.median), fmt::format("mean {:.3g}", s.mean),
        fmt::format("95 % {:.3g}", s.p95),
        fmt::format(
            "outliers {:.1f} %",
            s.count > 0 ? 100. * static_cast<double>(s.outliers) / static_cast<double>(s.count) : 0.)};
    const int height = column < 130 ? kTextHeight - 3 : kTextHeight;
    for (size_t l = 0; l < lines.size(); ++l)
      canvas.text(lines[l], {x, bottom + kTextHeight * (.9 + 1.25 * static_cast<double>(l))},
                  TextAnchor::Center, height);
  }
}

}  // namespace

Image drawBoxPlot(const BoxPlot& plot, PlotSize size) {
  return drawBoxPlots(std::vector<BoxPlot>(1, plot), size);
}

Image drawBoxPlots(const std::vector<BoxPlot>& plots, PlotSize size) {
  PlotCanvas canvas(size);
  size_t columns = 0;
  for (const BoxPlot& plot : plots) columns += std::max<size_t>(plot.boxes.size(), 1);
  int left = 0;
  size_t used = 0;
  for (const BoxPlot& plot : plots) {
    used += std::max<size_t>(plot.boxes.size(), 1);
    const int right = static_cast<int>(static_cast<size_t>(size.width) * used / columns);
    drawBoxes(canvas, {left, 0, right - left, size.height}, plot);
    left = right;
  }
  return canvas.image();
}

}  // namespace swaplight
