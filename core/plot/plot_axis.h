#pragma once

#include <string>
#include <vector>

#include "core/plot/plot.h"

namespace swaplight {

/// An axis with limits and ticks: what a PlotAxis becomes once the data are known.
struct AxisScale {
  std::string label = {};
  bool log = false;
  double low = 0, high = 1;
  std::vector<double> ticks = {};

  /// Where a value lies: 0 at the low end, 1 at the high end. May lie outside.
  [[nodiscard]] double fraction(double value) const;
};

/// Limits that hold all drawable values (and 5 % of air) unless the axis has its own; round ticks.
[[nodiscard]] AxisScale scaleAxis(const PlotAxis& axis, const std::vector<double>& values);
[[nodiscard]] std::string tickText(double value);

}  // namespace swaplight
