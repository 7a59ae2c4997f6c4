#include "core/measure/lab.h"

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

// Rec.709 primaries and the white of D65 (x .3127, y .3290).
constexpr double kXyzFromRec709[3][3] = {
    {.4123908, .3575843, .1804808}, {.2126390, .7151687, .0721923}, {.0193308, .1191948, .9505322}};
constexpr double kWhite[3] = {.95045593, 1., 1.08905775};

// CIE 15: the cube root, made linear near black.
double labCurve(double t) {
  constexpr double kKnee = 6. / 29.;
  return t > kKnee * kKnee * kKnee ? std::cbrt(t) : t / (3 * kKnee * kKnee) + 4. / 29.;
}

}  // namespace

Lab labFromLinearRec709(double r, double g, double b) {
  const double rgb[3] = {std::clamp(r, 0., 1.), std::clamp(g, 0., 1.), std::clamp(b, 0., 1.)};
  double f[3];
  for (int i = 0; i < 3; ++i) {
    const double* row = kXyzFromRec709[i];
    f[i] = labCurve((row[0] * rgb[0] + row[1] * rgb[1] + row[2] * rgb[2]) / kWhite[i]);
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

}  // namespace swaplight
