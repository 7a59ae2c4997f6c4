#include <algorithm>
#include <climits>
#include <cmath>
#include <stdexcept>

#include "core/plot/plot_canvas.h"
#include "core/plot/text_drawing.h"

namespace swaplight {
namespace {

bool drawable(const AxisScale& axis, double value) {
  return std::isfinite(value) && (!axis.log || value > 0);
}

void drawSeries(PlotCanvas& canvas, const PlotFrame& frame, const AxisScale& x, const AxisScale& y,
                const ScatterPlot::Series& series, const cv::Scalar& color) {
  using Style = ScatterPlot::Style;
  const bool dots = series.style == Style::Points || series.style == Style::LineAndPoints;
  bool connected = false;
  cv::Point2d previous;
  for (size_t i = 0; i < series.x.size(); ++i) {
    if (!drawable(x, series.x[i]) || !drawable(y, series.y[i])) {
      connected = false;
      continue;
    }
    const cv::Point2d point = frame.at(series.x[i], series.y[i]);
    if (connected && series.style == Style::Steps) {
      canvas.line(previous, {point.x, previous.y}, color, 2);
      canvas.line({point.x, previous.y}, point, color, 2);
    } else if (connected && series.style != Style::Points) {
      canvas.line(previous, point, color, 2);
    }
    if (dots) canvas.dot(point, 4.5, color);
    if (i < series.labels.size()) {
      // Beside the point, on the side where there is room.
      const int width = textSize(series.labels[i], kTextHeight - 2).width;
      const bool left = point.x + 10 + width > frame.inner().br().x;
      canvas.text(series.labels[i], {point.x + (left ? -10 : 10), point.y - 9},
                  left ? TextAnchor::Right : TextAnchor::Left, kTextHeight - 2);
    }
    previous = point;
    connected = true;
  }
}

// How much of the series a box would cover.
int coveredBy(const cv::Rect2d& box, const PlotFrame& frame, const std::vector<ScatterPlot::Series>& series) {
  int covered = 0;
  for (const auto& s : series)
    for (size_t i = 0; i < s.x.size(); ++i) {
      const cv::Point2d point = frame.at(s.x[i], s.y[i]);
      covered += box.contains(point) ? 4 : 0;
      if (i < s.labels.size()) covered += box.contains(point + cv::Point2d(25, -9)) ? 4 : 0;
      if (i == 0 || s.style == ScatterPlot::Style::Points) continue;
      const cv::Point2d before = frame.at(s.x[i - 1], s.y[i - 1]);
      for (const double t : {.2, .4, .6, .8}) covered += box.contains(before + t * (point - before)) ? 1 : 0;
    }
  return covered;
}

// Names of the series on white, in the corner of the frame where they cover least.
void drawLegend(PlotCanvas& canvas, const PlotFrame& frame, const std::vector<ScatterPlot::Series>& series) {
  int width = 0;
  int rows = 0;
  for (const auto& s : series) {
    if (s.name.empty()) continue;
    width = std::max(width, textSize(s.name, kTextHeight).width);
    ++rows;
  }
  if (rows == 0) return;
  const double step = kTextHeight * 1.4;
  const cv::Rect2d inner = frame.inner();
  const cv::Size2d size(width + 40., rows * step + 8);
  const double left = inner.x + 6;
  const double right = inner.br().x - size.width - 6;
  const double top = inner.y + 6;
  const double bottom = inner.br().y - size.height - 6;
  cv::Rect2d box;
  int least = INT_MAX;
  for (const cv::Point2d corner : {cv::Point2d(right, top), {left, top}, {right, bottom}, {left, bottom}}) {
    const int covered = coveredBy({corner, size}, frame, series);
    if (covered >= least) continue;
    least = covered;
    box = {corner, size};
  }
  canvas.rectangle(box, cv::Scalar::all(255), PlotCanvas::kGrid);
  double y = box.y + 4 + step / 2;
  for (size_t i = 0; i < series.size(); ++i) {
    if (series[i].name.empty()) continue;
    const cv::Scalar color = PlotCanvas::seriesColor(i);
    if (series[i].style != ScatterPlot::Style::Points) canvas.line({box.x + 6, y}, {box.x + 26, y}, color, 2);
    if (series[i].style != ScatterPlot::Style::Line && series[i].style != ScatterPlot::Style::Steps)
      canvas.dot({box.x + 16, y}, 4.5, color);
    canvas.text(series[i].name, {box.x + 34, y}, TextAnchor::Left, kTextHeight);
    y += step;
  }
}

}  // namespace

Image drawScatterPlot(const ScatterPlot& plot, PlotSize size) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const ScatterPlot::Series& s : plot.series) {
    if (s.x.size() != s.y.size()) throw std::invalid_argument("drawScatterPlot: x and y differ in count");
    xs.insert(xs.end(), s.x.begin(), s.x.end());
    ys.insert(ys.end(), s.y.begin(), s.y.end());
  }
  const AxisScale x = scaleAxis(plot.x, xs);
  const AxisScale y = scaleAxis(plot.y, ys);
  PlotCanvas canvas(size);
  const PlotFrame frame(canvas, canvas.bounds(), plot.title, &x, y);
  for (size_t i = 0; i < plot.series.size(); ++i)
    drawSeries(canvas, frame, x, y, plot.series[i], PlotCanvas::seriesColor(i));
  drawLegend(canvas, frame, plot.series);
  return canvas.image();
}

}  // namespace swaplight
