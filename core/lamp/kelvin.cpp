#include "core/lamp/kelvin.h"

#include <algorithm>
#include <cmath>

#include "core/color/planck.h"

namespace swaplight {
namespace {

constexpr double kPlanckianUpTo = 4000;
constexpr double kDaylightFrom = 5000;

/// A light of chromaticity a and one of b, both of luminance 1, mixed.
Chromaticity mix(const Chromaticity& a, const Chromaticity& b, double weightOfB) {
  const double wa = (1 - weightOfB) / a.y;  // X + Y + Z of each
  const double wb = weightOfB / b.y;
  return {(wa * a.x + wb * b.x) / (wa + wb), (wa * a.y + wb * b.y) / (wa + wb)};
}

/// The unit normal of the black-body locus in u, v, pointing to green.
Uv greenward(double kelvin) {
  const Uv a = uvFromXy(planckianXy(kelvin * 0.999));
  const Uv b = uvFromXy(planckianXy(kelvin * 1.001));
  const double du = b.u - a.u;
  const double dv = b.v - a.v;
  const double length = std::hypot(du, dv);
  return {dv / length, -du / length};
}

}  // namespace

Chromaticity daylightXy(double kelvin) {
  const double t = 1e3 / kelvin;
  const double x = kelvin <= 7000 ? ((-4.6070 * t + 2.9678) * t + 0.09911) * t + 0.244063
                                  : ((-2.0064 * t + 1.9018) * t + 0.24748) * t + 0.237040;
  return {x, (-3.000 * x + 2.870) * x - 0.275};
}

Chromaticity whiteXy(double kelvin) {
  if (kelvin <= kPlanckianUpTo) return planckianXy(kelvin);
  if (kelvin < kDaylightFrom)
    return mix(planckianXy(kelvin), daylightXy(kelvin),
               (kelvin - kPlanckianUpTo) / (kDaylightFrom - kPlanckianUpTo));
  if (kelvin <= kHighestKelvin) return daylightXy(kelvin);
  const Uv planckian = uvFromXy(planckianXy(kelvin));
  const Uv lastPlanckian = uvFromXy(planckianXy(kHighestKelvin));
  const Uv lastDaylight = uvFromXy(daylightXy(kHighestKelvin));
  return xyFromUv(
      {planckian.u + lastDaylight.u - lastPlanckian.u, planckian.v + lastDaylight.v - lastPlanckian.v});
}

Chromaticity whiteXy(double kelvin, double duv) {
  const Chromaticity white = whiteXy(kelvin);
  if (duv == 0) return white;
  const Uv uv = uvFromXy(white);
  const Uv normal = greenward(kelvin);
  return xyFromUv({uv.u + duv * normal.u, uv.v + duv * normal.v});
}

CorrelatedTemperature correlatedTemperature(const Chromaticity& xy) {
  const Uv uv = uvFromXy(xy);
  const auto distance = [&](double mired) {
    const Uv locus = uvFromXy(planckianXy(1e6 / mired));
    return std::hypot(uv.u - locus.u, uv.v - locus.v);
  };
  constexpr double kGolden = 0.6180339887498949;
  double low = 1e6 / kHighestKelvin;
  double high = 1e6 / kLowestKelvin;
  double a = high - kGolden * (high - low);
  double b = low + kGolden * (high - low);
  double atA = distance(a);
  double atB = distance(b);
  while (high - low > 0.01) {
    if (atA < atB) {
      high = b, b = a, atB = atA;
      a = high - kGolden * (high - low);
      atA = distance(a);
    } else {
      low = a, a = b, atA = atB;
      b = low + kGolden * (high - low);
      atB = distance(b);
    }
  }
  const double kelvin = 2e6 / (low + high);
  const Uv locus = uvFromXy(planckianXy(kelvin));
  const Uv normal = greenward(kelvin);
  const double across = (uv.u - locus.u) * normal.u + (uv.v - locus.v) * normal.v;
  return {kelvin, std::copysign(std::hypot(uv.u - locus.u, uv.v - locus.v), across)};
}

}  // namespace swaplight
