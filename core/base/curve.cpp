#include "core/base/curve.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace swaplight {
namespace {

// Slopes at the points: zero at peaks and plateaus, else the weighted harmonic mean of its neighbours'
// (Fritsch and Butland's form of the condition).
std::vector<double> slopesOf(const CurvePoints& p) {
  const size_t n = p.size();
  std::vector<double> secant(n > 0 ? n - 1 : 0);
  for (size_t i = 0; i + 1 < n; ++i)
    secant[i] = (double{p[i + 1][1]} - p[i][1]) / (double{p[i + 1][0]} - p[i][0]);
  std::vector<double> slope(n, 0.);
  if (n < 2) return slope;
  slope.front() = secant.front();
  slope.back() = secant.back();
  for (size_t i = 1; i + 1 < n; ++i) {
    if (secant[i - 1] * secant[i] <= 0) continue;
    const double before = double{p[i][0]} - p[i - 1][0];
    const double after = double{p[i + 1][0]} - p[i][0];
    const double w1 = 2 * after + before;
    const double w2 = after + 2 * before;
    slope[i] = (w1 + w2) / (w1 / secant[i - 1] + w2 / secant[i]);
  }
  return slope;
}

}  // namespace

std::vector<double> curveSlopes(const CurvePoints& points) {
  if (points.empty()) throw InputError("the curve has no points, expected at least one.");
  for (size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(points[i][0]) || !std::isfinite(points[i][1]) ||
        (i > 0 && !(points[i][0] > points[i - 1][0])))
      throw InputError("the curve's point {} is not right of the one before it.", i + 1);
  return slopesOf(points);
}

std::vector<float> curveTable(const CurvePoints& points, int count) {
  const std::vector<double> slope = curveSlopes(points);
  std::vector<float> table(static_cast<size_t>(count));
  size_t piece = 0;
  for (int k = 0; k < count; ++k) {
    const double x = static_cast<double>(k) / (count - 1);
    while (piece + 2 < points.size() && x >= points[piece + 1][0]) ++piece;
    float& y = table[static_cast<size_t>(k)];
    if (x <= points.front()[0]) {
      y = points.front()[1];
    } else if (x >= points.back()[0]) {
      y = points.back()[1];
    } else {
      const auto& a = points[piece];
      const auto& b = points[piece + 1];
      const double h = double{b[0]} - a[0];
      const double t = (x - a[0]) / h;
      const double u = 1 - t;
      y = static_cast<float>(u * u * (1 + 2 * t) * a[1] + t * t * (3 - 2 * t) * b[1] +
                             h * t * u * (u * slope[piece] - t * slope[piece + 1]));
    }
  }
  return table;
}

}  // namespace swaplight
