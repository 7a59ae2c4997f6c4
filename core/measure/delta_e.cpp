#include "core/measure/delta_e.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double pow7(double x) {
  const double x2 = x * x;
  return x2 * x2 * x2 * x;
}

// sqrt(c^7 / (c^7 + 25^7)): 0 for greys, 1 for saturated colours.
double saturation(double chroma) {
  const double c7 = pow7(chroma);
  return std::sqrt(c7 / (c7 + 6103515625.));
}

double hueDegrees(double a, double b) {
  const double h = std::atan2(b, a) / kDegree;
  return h < 0 ? h + 360 : h;
}

bool isFinite(ImageView image, int x, int y) {
  return std::isfinite(image.at(0, x, y)) && std::isfinite(image.at(1, x, y)) &&
         std::isfinite(image.at(2, x, y));
}

Lab labAt(ImageView image, int x, int y, double scale) {
  return labFromLinearRec709(scale * image.at(0, x, y), scale * image.at(1, x, y), scale * image.at(2, x, y));
}

}  // namespace

double deltaE2000(const Lab& x, const Lab& y, const DeltaEWeights& weights) {
  // Chroma and hue, with a* stretched for colours near grey.
  const double stretch = 1 + .5 * (1 - saturation((std::hypot(x.a, x.b) + std::hypot(y.a, y.b)) / 2));
  const double ax = stretch * x.a;
  const double ay = stretch * y.a;
  const double cx = std::hypot(ax, x.b);
  const double cy = std::hypot(ay, y.b);
  const double hx = hueDegrees(ax, x.b);
  const double hy = hueDegrees(ay, y.b);
  const bool grey = cx * cy == 0;

  // Differences; hue goes the short way round.
  const double dL = y.L - x.L;
  const double dC = cy - cx;
  double dh = grey ? 0 : hy - hx;
  if (dh > 180) dh -= 360;
  if (dh < -180) dh += 360;
  const double dH = 2 * std::sqrt(cx * cy) * std::sin(dh / 2 * kDegree);

  // Means.
  const double meanL = (x.L + y.L) / 2;
  const double meanC = (cx + cy) / 2;
  double meanH = hx + hy;
  if (!grey) {
    if (std::abs(hx - hy) > 180) meanH += meanH < 360 ? 360 : -360;
    meanH /= 2;
  }

  // How much each weighs for the eye.
  const double t = 1 - .17 * std::cos((meanH - 30) * kDegree) + .24 * std::cos(2 * meanH * kDegree) +
                   .32 * std::cos((3 * meanH + 6) * kDegree) - .2 * std::cos((4 * meanH - 63) * kDegree);
  const double l50 = (meanL - 50) * (meanL - 50);
  const double sL = 1 + .015 * l50 / std::sqrt(20 + l50);
  const double sC = 1 + .045 * meanC;
  const double sH = 1 + .015 * meanC * t;
  const double blue = (meanH - 275) / 25;
  const double rT = -2 * saturation(meanC) * std::sin(60 * std::exp(-blue * blue) * kDegree);

  const double l = dL / (weights.lightness * sL);
  const double c = dC / (weights.chroma * sC);
  const double h = dH / (weights.hue * sH);
  return std::sqrt(l * l + c * c + h * h + rT * c * h);
}

void deltaE2000(ImageView test, ImageView reference, float scale, ImageSpan out,
                const DeltaEWeights& weights) {
  parallelRows(out.height, 8, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < out.width; ++x)
        out.at(0, x, y) = isFinite(test, x, y) && isFinite(reference, x, y)
                              ? static_cast<float>(deltaE2000(labAt(test, x, y, scale),
                                                              labAt(reference, x, y, scale), weights))
                              : std::numeric_limits<float>::quiet_NaN();
  });
}

}  // namespace swaplight
