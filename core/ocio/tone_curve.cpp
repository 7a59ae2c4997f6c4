#include "core/ocio/tone_curve.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace swaplight {
namespace {

void checkRange(const char* what, double value, double low, double high) {
  if (!(value >= low && value <= high))
    throw std::invalid_argument(fmt::format("{} is {}, expected {} to {}", what, value, low, high));
}

double hableCurve(double x) {
  constexpr double a = 0.15, b = 0.5, c = 0.1, d = 0.2, e = 0.02, f = 0.3;
  return (x * (a * x + c * b) + d * e) / (x * (a * x + b) + d * f) - e / f;
}

/// The curve's slope at 0: (B C D F - B D E) / (D F)^2 of f.
double hableSlope() {
  constexpr double b = 0.5, c = 0.1, d = 0.2, e = 0.02, f = 0.3;
  return (c * b * d * f - d * e * b) / (d * f * d * f);
}

constexpr double kLogScale = 4;

constexpr double kAgxDarkest = -10, kAgxBrightest = 6.5;  // stops about middle grey
constexpr double kAgxSlope = 2.4, kAgxPower = 1.5, kAgxGamma = 2.4;

/// How far the sigmoid is from its pivot at a distance from it: the line of kAgxSlope through the pivot, bent
/// so that it reaches `height` at `width`, l / (1 + b l^p)^(1/p) with b from that end.
double agxFromPivot(double distance, double width, double height) {
  const double line = kAgxSlope * distance;
  const double bend =
      std::pow(kAgxSlope * width, -kAgxPower) * (std::pow(kAgxSlope * width / height, kAgxPower) - 1);
  return line / std::pow(1 + bend * std::pow(line, kAgxPower), 1 / kAgxPower);
}

}  // namespace

double reinhardGlobal(double light) {
  if (std::isinf(light) && light > 0) return 1;
  return light < 0 ? light : light / (1 + light);
}

double reinhardExtended(double light, double white) {
  checkRange("white", white, 0.5, 1e4);
  if (light >= white) return 1;
  return light < 0 ? light : light * (1 + light / (white * white)) / (1 + light);
}

double hable(double light, double exposure, double white) {
  checkRange("exposure", exposure, 0.01, 100);
  checkRange("white", white, 1, 1e4);
  const double top = hableCurve(white);
  if (light < 0) return light * exposure * hableSlope() / top;
  return std::min(1.0, hableCurve(std::min(light * exposure, white)) / top);
}

double logarithmic(double light, double brightest) {
  checkRange("brightest", brightest, 1, 1e6);
  const double top = std::log1p(kLogScale * brightest);
  if (light < 0) return light * kLogScale / top;
  return light >= brightest ? 1 : std::log1p(kLogScale * light) / top;
}

double agxCurve(double light) {
  if (!(light > 0)) return 0;
  const double stops = std::clamp(std::log2(light / kMiddleGrey), kAgxDarkest, kAgxBrightest);
  const double at = (stops - kAgxDarkest) / (kAgxBrightest - kAgxDarkest);
  const double pivot = -kAgxDarkest / (kAgxBrightest - kAgxDarkest);
  const double grey = std::pow(kMiddleGrey, 1 / kAgxGamma);
  const double code = at < pivot ? grey - agxFromPivot(pivot - at, pivot, grey)
                                 : grey + agxFromPivot(at - pivot, 1 - pivot, 1 - grey);
  return std::pow(std::max(code, 0.0), kAgxGamma);
}

std::span<const ToneCurve> toneCurves() {
  static constexpr std::array<ToneCurve, 4> curves = {
      {{"Reinhard", "Reinhard 2002, global: x / (1 + x); keeps everything below white",
        [](double x) { return reinhardGlobal(x); }},
       {"Reinhard extended", "Reinhard 2002 with a white: two stops above full scale become white",
        [](double x) { return reinhardExtended(x); }},
       {"Hable", "Hable 2010, filmic: a soft toe and shoulder", [](double x) { return hable(x); }},
       {"Logarithmic",
        "Six stops above full scale are seen: dark parts are raised, for looking into the shadows",
        [](double x) { return logarithmic(x); }}}};
  return curves;
}

}  // namespace swaplight
