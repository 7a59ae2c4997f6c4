#include "core/chart/chart_corners.h"

#include <Eigen/Core>
#include <cmath>

#include "core/base/error.h"
#include "core/linear/decompositions.h"

namespace swaplight {
namespace {

constexpr std::array<ChartPlace, 4> kChart{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

double turn(const PicturePlace& a, const PicturePlace& b, const PicturePlace& c) {
  return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

/// Convex, and not flat.
bool isQuadrangle(const ChartCorners& corners) {
  double least = INFINITY, most = -INFINITY;
  for (size_t j = 0; j < 4; ++j) {
    const double one = turn(corners[j], corners[(j + 1) % 4], corners[(j + 2) % 4]);
    least = std::min(least, one);
    most = std::max(most, one);
  }
  return std::isfinite(least) && std::isfinite(most) && (least > 1 || most < -1);
}

std::array<double, 2> mapped(const std::array<double, 9>& m, double x, double y) {
  const double w = m[6] * x + m[7] * y + m[8];
  return {(m[0] * x + m[1] * y + m[2]) / w, (m[3] * x + m[4] * y + m[5]) / w};
}

}  // namespace

ChartPerspective::ChartPerspective(const ChartCorners& corners) {
  if (!isQuadrangle(corners))
    throw InputError(
        "the four corners are no quadrangle: tell them one after the other around the chart, as X,Y of each");
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(8, 8);
  Eigen::VectorXd b(8);
  for (int j = 0; j < 4; ++j) {
    const auto [u, v] = kChart[size_t(j)];
    const auto [x, y] = corners[size_t(j)];
    a.row(2 * j) << u, v, 1, 0, 0, 0, -u * x, -v * x;
    a.row(2 * j + 1) << 0, 0, 0, u, v, 1, -u * y, -v * y;
    b[2 * j] = x;
    b[2 * j + 1] = y;
  }
  const Eigen::VectorXd h = leastSquares(a, b);
  Eigen::Matrix3d picture;
  picture << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], 1;
  const Eigen::MatrixXd chart = inverseOf(picture);
  for (int j = 0; j < 9; ++j) {
    m_picture[size_t(j)] = picture(j / 3, j % 3);
    m_chart[size_t(j)] = chart(j / 3, j % 3);
  }
}

PicturePlace ChartPerspective::inPicture(const ChartPlace& chart) const {
  const auto [x, y] = mapped(m_picture, chart.x, chart.y);
  return {x, y};
}

ChartPlace ChartPerspective::inChart(const PicturePlace& picture) const {
  const auto [x, y] = mapped(m_chart, picture.x, picture.y);
  return {x, y};
}

std::array<ChartCorners, 8> arrangementsOf(const ChartCorners& corners) {
  std::array<ChartCorners, 8> all;
  for (size_t way = 0; way < 8; ++way)
    for (size_t j = 0; j < 4; ++j) all[way][j] = corners[way < 4 ? (way + j) % 4 : (way + 4 - j) % 4];
  return all;
}

}  // namespace swaplight
