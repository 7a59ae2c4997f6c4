#include "core/solve/model/variance_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/linear/decompositions.h"

namespace swaplight {

std::array<double, 3> fitVariance(std::span<const VariancePoint> points) {
  const long count = long(points.size());
  Eigen::MatrixXd powers(count, 3);
  for (long j = 0; j < count; ++j) {
    const auto& [y, target] = points[size_t(j)];
    powers.row(j) << 1 / target, y / target, y * y / target;
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(count);
  // The best of all subsets whose solution is not negative.
  std::array<double, 3> best{};
  double smallest = double(count);
  for (int subset = 1; subset < 8; ++subset) {
    std::vector<int> columns;
    for (int j = 0; j < 3; ++j)
      if (subset >> j & 1) columns.push_back(j);
    const Eigen::MatrixXd part = powers(Eigen::all, columns);
    const Eigen::VectorXd x = leastSquares(part, ones);
    if (x.minCoeff() < 0) continue;
    const double left = (part * x - ones).squaredNorm();
    if (left >= smallest) continue;
    smallest = left;
    best = {};
    for (size_t j = 0; j < columns.size(); ++j) best[size_t(columns[j])] = x[long(j)];
  }
  return best;
}

std::array<double, 2> varianceBelow(std::span<const VariancePoint> points) {
  const auto slopeAt = [&](double constant) {
    double slope = INFINITY;
    for (const auto& [y, variance] : points)
      if (y > 0) slope = std::min(slope, (variance - constant) / y);
    return std::isfinite(slope) ? std::max(slope, 0.0) : 0.0;
  };
  const auto sumAt = [&](double constant) {
    const double slope = slopeAt(constant);
    double sum = 0;
    for (const auto& [y, variance] : points)
      sum += std::log(std::max(constant + slope * std::max(y, 0.0), 1e-30));
    return sum;
  };
  double least = 0;
  double most = INFINITY;
  for (const auto& point : points) most = std::min(most, point.variance);
  if (!std::isfinite(most)) return {};
  // The sum is concave.
  constexpr int kThirds = 60;
  for (int j = 0; j < kThirds; ++j) {
    const double a = least + (most - least) / 3;
    const double b = most - (most - least) / 3;
    if (sumAt(a) < sumAt(b))
      least = a;
    else
      most = b;
  }
  const double constant = (least + most) / 2;
  return {constant, slopeAt(constant)};
}

}  // namespace swaplight
