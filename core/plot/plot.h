#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/plot/statistics.h"

namespace swaplight {

// Plots as pictures: dark text on white, R G B code values 0..1 (sRGB), to be written as PNG.

/// A labelled axis. Limits that are not given are taken from the data. On a logarithmic axis values that are
/// not above 0 are not drawn.
struct PlotAxis {
  std::string label;
  bool log = false;
  std::optional<double> low, high;
};

struct PlotSize {
  int width = 900;
  int height = 600;
};

/// Box plots beside each other on one axis: box = quartiles, line = median, diamond = mean, whiskers =
/// Tukey's, above each its count of outliers.
struct BoxPlot {
  struct Box {
    std::string name;
    Statistics statistics;
  };
  std::string title;
  PlotAxis value;
  std::vector<Box> boxes;
};
[[nodiscard]] Image drawBoxPlot(const BoxPlot& plot, PlotSize size = {});
/// Several plots side by side, each with its own axis, shared out over the width.
[[nodiscard]] Image drawBoxPlots(const std::vector<BoxPlot>& plots, PlotSize size = {});

/// Points, lines and histogram steps over two axes. Points that are not finite are left out.
struct ScatterPlot {
  enum class Style { Points, Line, LineAndPoints, Steps };
  struct Series {
    std::string name;  ///< in the legend; empty: not there
    std::vector<double> x, y;
    Style style = Style::Points;
    std::vector<std::string> labels = {};  ///< a name beside each point, or none
  };
  std::string title;
  PlotAxis x, y;
  std::vector<Series> series;
};
/// Throws std::invalid_argument where a series' x and y differ in count.
[[nodiscard]] Image drawScatterPlot(const ScatterPlot& plot, PlotSize size = {});

}  // namespace swaplight
