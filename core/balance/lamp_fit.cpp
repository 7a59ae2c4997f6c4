#include "core/balance/lamp_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/linear/decompositions.h"

namespace swaplight {
namespace {

constexpr double kTukey = 4.685;   // 95 % efficient at normal residuals (Huber 1981)
constexpr double kCauchy = 2.385;  // the same
constexpr int kCauchyRounds = 6, kMostRounds = 40;
constexpr double kConverged = 1e-6;    // relative change of a level
constexpr double kNormal = 1.4826;     // standard deviation over the median of |x|, normal
constexpr double kMedianChi3 = 2.366;  // of a chi-square with three degrees of freedom
constexpr double kBlock = 4;           // pixels of a block, whose noise is independent
constexpr double kFaintest = 1e-6;     // of the largest value: below, a ratio to it tells nothing
constexpr double kUntold = 1e-12;      // an eigenvalue of the correlations that is rounding

/// The normal equations of one channel.
struct ChannelSums {
  Eigen::MatrixXd squares;
  Eigen::VectorXd products;
};

class Fit {
 public:
  Fit(const LampBlocks& blocks, const NoiseModel& noise)
      : m_blocks(blocks), m_noise(noise), m_columns(blocks.columnCount()) {
    m_unknowns = 3 * blocks.lights + (blocks.ambient ? 1 : 0);
    m_fit.level = Eigen::VectorXd::Zero(m_unknowns);
    m_fit.weight.assign(blocks.count, 1);
    for (int c = 0; c < 3; ++c) {
      m_predicted[c].assign(blocks.value[c].begin(), blocks.value[c].end());  // a start
      m_variance[c].resize(blocks.count);
      m_brightest = std::max(m_brightest, largest(blocks.value[c]));
    }
  }

  LampFit run() {
    for (int round = 0; round < kMostRounds; ++round) {
      estimateVariances();
      if (round > 0) weigh(round <= kCauchyRounds);
      const Eigen::VectorXd before = m_fit.level;
      solve();
      predict();
      estimateMisfit();
      const double change = (m_fit.level - before).cwiseAbs().maxCoeff();
      if (round > kCauchyRounds && change <= kConverged * m_fit.level.maxCoeff()) break;
    }
    describeSeparation();
    estimateCovariance();
    return std::move(m_fit);
  }

 private:
  static float largest(const std::vector<float>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  }
  [[nodiscard]] const float* row(int c, size_t b) const {
    return m_blocks.columns[size_t(c)].data() + b * size_t(m_columns);
  }
  /// Where a channel's column stands among the unknowns; the ambient light's level is that of all channels.
  [[nodiscard]] int unknown(int c, int column) const {
    return column < m_blocks.lights ? c * m_blocks.lights + column : m_unknowns - 1;
  }

  void estimateVariances() {
    double square = 0;  // mean of the squared levels: how much of a contribution's error is seen
    for (int u = 0; u < m_unknowns; ++u) square += m_fit.level[u] * m_fit.level[u] / m_unknowns;
    const double kappa = m_kappa * m_kappa;
    parallelEach(3, [&](int c) {
      for (size_t b = 0; b < m_blocks.count; ++b) {
        const double f = std::max(0.0, m_predicted[c][b]);
        double sum = 0;
        for (int i = 0; i < m_blocks.lights; ++i) sum += row(c, b)[i];
        const double ofSet = m_blocks.sigma[b] * sum;
        m_variance[c][b] = (double(m_noise.variance(float(f))) + square * ofSet * ofSet) / kBlock +
                           kappa * f * f + 1e-14 * m_brightest * m_brightest;
      }
    });
  }

  /// The weights of what fits badly, in all channels together.
  void weigh(bool cauchy) {
    std::vector<double> distance(m_blocks.count);
    for (size_t b = 0; b < m_blocks.count; ++b) {
      double square = 0;
      for (int c = 0; c < 3; ++c) {
        const double r = m_blocks.value[c][b] - m_predicted[c][b];
        square += r * r / m_variance[c][b];
      }
      distance[b] = std::sqrt(square / 3);
    }
    std::vector<double> sorted = distance;
    const double scale = std::max(1.0, median(std::span(sorted)) / std::sqrt(kMedianChi3 / 3));
    for (size_t b = 0; b < m_blocks.count; ++b) {
      const double u = distance[b] / (scale * (cauchy ? kCauchy : kTukey));
      const double rest = std::max(0.0, 1 - u * u);
      m_fit.weight[b] = float(cauchy ? 1 / (1 + u * u) : rest * rest);
    }
  }

  [[nodiscard]] ChannelSums sums(int c) const {
    ChannelSums sums{Eigen::MatrixXd::Zero(m_columns, m_columns), Eigen::VectorXd::Zero(m_columns)};
    for (size_t b = 0; b < m_blocks.count; ++b) {
      const double w = m_fit.weight[b] / m_variance[c][b];
      if (w == 0) continue;
      const float* a = row(c, b);
      for (int i = 0; i < m_columns; ++i) {
        sums.products[i] += w * a[i] * m_blocks.value[c][b];
        for (int j = 0; j <= i; ++j) sums.squares(i, j) += w * a[i] * a[j];
      }
    }
    sums.squares = sums.squares.selfadjointView<Eigen::Lower>();
    return sums;
  }

  void solve() {
    std::array<ChannelSums, 3> channel;
    parallelEach(3, [&](int c) { channel[size_t(c)] = sums(c); });
    m_squares = Eigen::MatrixXd::Zero(m_unknowns, m_unknowns);
    Eigen::VectorXd products = Eigen::VectorXd::Zero(m_unknowns);
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < m_columns; ++i) {
        products[unknown(c, i)] += channel[size_t(c)].products[i];
        for (int j = 0; j < m_columns; ++j)
          m_squares(unknown(c, i), unknown(c, j)) += channel[size_t(c)].squares(i, j);
      }
    m_fit.level = notNegative(products);
  }

  /// The minimum without negative levels: the most negative one is held at 0 until there is none. What no
  /// block tells stays 0.
  [[nodiscard]] Eigen::VectorXd notNegative(const Eigen::VectorXd& products) const {
    std::vector<int> free;
    for (int u = 0; u < m_unknowns; ++u)
      if (m_squares(u, u) > 0) free.push_back(u);
    Eigen::VectorXd level = Eigen::VectorXd::Zero(m_unknowns);
    while (!free.empty()) {
      const Eigen::VectorXd found = solved(free, products);
      Eigen::Index lowest = 0;
      if (found.minCoeff(&lowest) >= 0) {
        for (size_t k = 0; k < free.size(); ++k) level[free[k]] = found[Eigen::Index(k)];
        break;
      }
      free.erase(free.begin() + lowest);
    }
    return level;
  }

  /// Of lights that nothing tells apart, the share of each is the smallest that explains the picture.
  [[nodiscard]] Eigen::VectorXd solved(const std::vector<int>& free, const Eigen::VectorXd& products) const {
    const auto n = Eigen::Index(free.size());
    Eigen::MatrixXd a(n, n);
    Eigen::VectorXd b(n), scale(n);
    for (Eigen::Index i = 0; i < n; ++i)
      scale[i] = 1 / std::sqrt(m_squares(free[size_t(i)], free[size_t(i)]));
    for (Eigen::Index i = 0; i < n; ++i) {
      b[i] = scale[i] * products[free[size_t(i)]];
      for (Eigen::Index j = 0; j < n; ++j)
        a(i, j) = scale[i] * scale[j] * m_squares(free[size_t(i)], free[size_t(j)]);
    }
    a.diagonal().array() += kUntold;
    return scale.cwiseProduct(solveSymmetric(a, b).col(0));
  }

  void predict() {
    parallelEach(3, [&](int c) {
      for (size_t b = 0; b < m_blocks.count; ++b) {
        double f = 0;
        for (int i = 0; i < m_columns; ++i) f += m_fit.level[unknown(c, i)] * row(c, b)[i];
        m_predicted[c][b] = f;
      }
    });
  }

  /// How far predictions are off where the picture is bright, relative; what of it is no noise.
  void estimateMisfit() {
    std::vector<double> bright;
    for (int c = 0; c < 3; ++c) bright.insert(bright.end(), m_predicted[c].begin(), m_predicted[c].end());
    const double level = std::max(median(std::span(bright)), kFaintest * m_brightest);
    std::vector<double> residuals, noises;
    for (int c = 0; c < 3; ++c)
      for (size_t b = 0; b < m_blocks.count; ++b) {
        const double f = m_predicted[c][b];
        if (!(f > level)) continue;
        residuals.push_back(std::abs(m_blocks.value[c][b] - f) / f);
        noises.push_back(std::max(0.0, m_variance[c][b] - m_kappa * m_kappa * f * f) / (f * f));
      }
    if (residuals.empty()) return;
    m_fit.misfit = kNormal * median(std::span(residuals));
    m_fit.noise = std::sqrt(median(std::span(noises)));
    m_kappa = std::sqrt(std::max(0.0, m_fit.misfit * m_fit.misfit - m_fit.noise * m_fit.noise));
  }

  void describeSeparation() {
    for (int c = 0; c < 3; ++c) {
      const Eigen::MatrixXd channel =
          m_squares.block(c * m_blocks.lights, c * m_blocks.lights, m_blocks.lights, m_blocks.lights);
      Eigen::VectorXd scale = channel.diagonal().cwiseSqrt();
      for (double& s : scale) s = s > 0 ? 1 / s : 0;
      const SymmetricEigen eigen = symmetricEigen(scale.asDiagonal() * channel * scale.asDiagonal());
      m_fit.separation[size_t(c)] =
          std::max(0.0, eigen.values[0]) / std::max(eigen.values[m_blocks.lights - 1], kUntold);
      m_fit.weakest[size_t(c)] = eigen.vectors.col(0);
    }
  }

  void estimateCovariance() {
    Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(m_unknowns, kLampTiles);
    for (int c = 0; c < 3; ++c)
      for (size_t b = 0; b < m_blocks.count; ++b) {
        const double w = m_fit.weight[b] / m_variance[c][b] * (m_blocks.value[c][b] - m_predicted[c][b]);
        for (int i = 0; i < m_columns; ++i) scores(unknown(c, i), m_blocks.tile[b]) += w * row(c, b)[i];
      }
    Eigen::VectorXd scale = m_squares.diagonal().cwiseSqrt();
    for (double& s : scale) s = s > 0 ? 1 / s : 0;
    Eigen::MatrixXd correlations = scale.asDiagonal() * m_squares * scale.asDiagonal();
    correlations.diagonal().array() += kUntold;
    const Eigen::MatrixXd spread =
        Eigen::MatrixXd(scale.asDiagonal()) * solveSymmetric(correlations, scale.asDiagonal() * scores);
    m_fit.covariance = spread * spread.transpose() * (double(kLampTiles) / (kLampTiles - 1));
    for (int u = 0; u < m_unknowns; ++u)
      if (scale[u] == 0) m_fit.covariance(u, u) = std::numeric_limits<double>::infinity();
  }

  const LampBlocks& m_blocks;
  const NoiseModel& m_noise;
  int m_columns;
  int m_unknowns = 0;
  double m_kappa = 0;
  float m_brightest = 0;
  std::array<std::vector<double>, 3> m_predicted, m_variance;
  Eigen::MatrixXd m_squares;
  LampFit m_fit;
};

}  // namespace

LampFit fitLamps(const LampBlocks& blocks, const NoiseModel& noise) {
  return Fit(blocks, noise).run();
}

}  // namespace swaplight
