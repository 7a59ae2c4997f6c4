#include "core/plot/plot_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

// 1, 2 or 5 times a power of ten: about `count` steps over the range.
double roundStep(double range, int count) {
  const double raw = range / count;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  for (const double step : {1., 2., 5.})
    if (raw <= step * power * 1.0001) return step * power;
  return 10 * power;
}

std::vector<double> linearTicks(double low, double high) {
  const double step = roundStep(high - low, 6);
  std::vector<double> ticks;
  for (double i = std::ceil(low / step - 1e-6); i * step <= high + 1e-6 * step; ++i)
    ticks.push_back(i * step);
  return ticks;
}

std::vector<double> logTicks(double low, double high) {
  const double decades = std::log10(high / low);
  if (decades < 1) return linearTicks(low, high);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / 8)));
  std::vector<double> ticks;
  for (int e = static_cast<int>(std::floor(std::log10(low))); e <= std::ceil(std::log10(high)); e += every)
    for (const double m : {1., 2., 5.}) {
      const double tick = m * std::pow(10, e);
      if ((m == 1 || decades < 3) && tick >= low * .9999 && tick <= high * 1.0001) ticks.push_back(tick);
    }
  return ticks;
}

}  // namespace

double AxisScale::fraction(double value) const {
  return log ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

AxisScale scaleAxis(const PlotAxis& axis, const std::vector<double>& values) {
  AxisScale scale{axis.label, axis.log};
  double low = INFINITY;
  double high = -INFINITY;
  for (const double v : values)
    if (std::isfinite(v) && (!axis.log || v > 0)) {
      low = std::min(low, v);
      high = std::max(high, v);
    }
  if (low > high) low = axis.log ? .1 : 0, high = 1;

  // Some air at both ends; a linear axis whose data are not negative starts at 0 if 0 is near.
  if (axis.log) {
    const double air = std::max(std::pow(high / low, .05), 1.1);
    low /= air, high *= air;
  } else {
    const double air = high > low ? .05 * (high - low) : std::max(std::abs(high) * .05, .5);
    low = low >= 0 && low < .5 * high ? 0 : low >= 0 ? std::max(0., low - air) : low - air;
    high += air;
  }
  scale.low = axis.low.value_or(low);
  scale.high = axis.high.value_or(high);
  if (!(scale.high > scale.low)) scale.high = scale.low + std::max(1., std::abs(scale.low));
  if (axis.log && scale.low <= 0) scale.low = scale.high * 1e-6;
  scale.ticks = axis.log ? logTicks(scale.low, scale.high) : linearTicks(scale.low, scale.high);
  return scale;
}

std::string tickText(double value) {
  return std::abs(value) < 1e-12 ? "0" : fmt::format("{:.6g}", value);
}

}  // namespace swaplight
