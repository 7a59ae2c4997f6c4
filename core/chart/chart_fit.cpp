#include "core/chart/chart_fit.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/quantile.h"
#include "core/chart/chart_warnings.h"
#include "core/color/chromaticity.h"
#include "core/linear/decompositions.h"
#include "core/measure/delta_e.h"

namespace swaplight {
namespace {

constexpr float kMostClipped = .02F;   // of a patch's pixels
constexpr size_t kFewestPatches = 12;  // of 24, half the freedom of the fit being of six numbers
constexpr size_t kFewestGreys = 2;
constexpr double kDarkest = .03;  // luminance below which lightness has no finer steps (the black patch)
constexpr double kTukey = 6;  // of the median residual's scale: a patch that is out, not one that is worse
constexpr double kLeastScale = 2e-3;                     // of lightness 1: a chart's own scatter
constexpr double kGreyTukey = 6, kLeastGreyScale = .01;  // relative: greys of one chart differ by that
constexpr double kFaintest = .02;  // of the brightest channel of the light: no matrix below
constexpr double kOutlier = .1;
constexpr double kMostMixed = .5;  // a camera's filters have no more of another channel taken off
constexpr int kMostRounds = 50;
constexpr double kSettled = 1e-9;

using Weights = std::array<double, kChartPatches>;

double tukey(double residual, double scale, double c) {
  const double t = residual / (c * scale);
  return t < 1 ? (1 - t * t) * (1 - t * t) : 0;
}

/// In units of the slope of lightness at the patch.
double stepsOf(size_t patch) {
  return std::pow(std::max(double(luminance(chartReflectances()[patch])), kDarkest), -2.0 / 3) / 3;
}

class ChartSolver {
 public:
  explicit ChartSolver(const ChartReading& reading) : m_reading(reading) {
    size_t seen = 0, greys = 0;
    for (size_t p = 0; p < kChartPatches; ++p) {
      const Rgb& mean = reading[p].mean;
      m_seen[p] = reading[p].clipped <= kMostClipped && std::max({mean.r, mean.g, mean.b}) > 0;
      seen += m_seen[p] ? 1 : 0;
      greys += m_seen[p] && p >= kFirstGrey ? 1 : 0;
    }
    if (seen < kFewestPatches || greys < kFewestGreys)
      throw InputError(
          "the chart is saturated or black: only {} of its {} patches can be used, and {} of its six greys; "
          "expose so that the white patch is below full scale",
          seen, kChartPatches, greys);
    m_weights.fill(1);
  }

  ChartFit solve() {
    for (int round = 0; round < kMostRounds; ++round) {
      fitLight();
      fitMatrix();
      if (fitField() < kSettled && round > 0) break;
    }
    return result();
  }

 private:
  /// Without the light, and as if the chart were evenly lit.
  [[nodiscard]] Eigen::Vector3d balanced(size_t p) const {
    const ChartPlace at = chartPatchPlace(p);
    const double field = std::exp(m_field[0] * (at.x - .5) + m_field[1] * (at.y - .5));
    Eigen::Vector3d value;
    for (int c = 0; c < 3; ++c) value[c] = double(m_reading[p].mean[c]) / (field * m_light[c]);
    return value;
  }

  static Eigen::Vector3d reflected(size_t p) {
    const Rgb& r = chartReflectances()[p];
    return {double(r.r), double(r.g), double(r.b)};
  }

  void fitLight() {
    for (int c = 0; c < 3; ++c) {
      m_light[c] = 1;
      std::vector<double> ratios, weights;
      for (size_t p = kFirstGrey; p < kChartPatches; ++p) {
        if (!m_seen[p]) continue;
        const double expected = (m_camera * reflected(p))[c];
        ratios.push_back(std::max(balanced(p)[c], 0.0) / expected);
        weights.push_back(expected * expected);  // dark ones have more glare and noise
      }
      meanRatio(ratios, weights, c);
    }
  }

  void meanRatio(const std::vector<double>& ratios, const std::vector<double>& weights, int c) {
    std::vector<double> order = ratios;
    double mean = median(std::span(order)), error = 0;
    for (int pass = 0; pass < 10; ++pass) {
      const double scale = std::max(kLeastGreyScale * mean, 1e-12);
      double sum = 0, total = 0, squares = 0, square = 0;
      for (size_t j = 0; j < ratios.size(); ++j) {
        const double w = weights[j] * tukey(std::abs(ratios[j] - mean), scale, kGreyTukey);
        sum += w * ratios[j], total += w, square += w * w;
        squares += w * (ratios[j] - mean) * (ratios[j] - mean);
      }
      if (!(total > 0)) break;
      mean = sum / total;
      const double count = total * total / square;  // as many patches as these weights are worth
      error = std::sqrt(squares / total / std::max(count - 1, 1.0));
    }
    m_light[c] = std::max(mean, 1e-9);
    m_lightError[c] = error;
  }

  /// Row i: r_i - x_g = M_ir (x_r - x_g) + M_ib (x_b - x_g).
  void fitMatrix() {
    m_matrix.setIdentity();
    if (!hasMatrix()) return;
    std::vector<size_t> used;
    for (size_t p = 0; p < kChartPatches; ++p)
      if (m_seen[p]) used.push_back(p);
    m_weights.fill(1);
    for (int pass = 0; pass < 10; ++pass) {
      Eigen::MatrixXd a(Eigen::Index(used.size()), 2), b(Eigen::Index(used.size()), 3);
      for (size_t j = 0; j < used.size(); ++j) {
        const double weight = std::sqrt(m_weights[used[j]]) * stepsOf(used[j]);
        const Eigen::Vector3d x = balanced(used[j]);
        a.row(Eigen::Index(j)) << weight * (x[0] - x[1]), weight * (x[2] - x[1]);
        b.row(Eigen::Index(j)) = weight * (reflected(used[j]).array() - x[1]).matrix().transpose();
      }
      const Eigen::MatrixXd found = leastSquares(a, b);
      for (int i = 0; i < 3; ++i) m_matrix.row(i) << found(0, i), 1 - found(0, i) - found(1, i), found(1, i);
      weigh(used);
    }
    if (const Eigen::Matrix3d camera = inverseOf(m_matrix);
        camera.allFinite() && camera.minCoeff() > -kMostMixed)
      m_camera = camera;
  }

  void weigh(const std::vector<size_t>& used) {
    std::vector<double> residuals;
    for (const size_t p : used)
      residuals.push_back(stepsOf(p) * (reflected(p) - m_matrix * balanced(p)).norm());
    std::vector<double> order = residuals;
    const double scale = std::max(1.4826 * median(std::span(order)), kLeastScale);
    for (size_t j = 0; j < used.size(); ++j) m_weights[used[j]] = tukey(residuals[j], scale, kTukey);
  }

  /// What is left of the logarithm of luminance, as a plane over the chart; returns how far it moved.
  double fitField() {
    if (!hasMatrix()) return 0;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(3, 3);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(3);
    for (size_t p = 0; p < kChartPatches; ++p) {
      const double reflects = double(luminance(chartReflectances()[p]));
      const Eigen::Vector3d color = m_matrix * balanced(p);
      const auto is = double(luminance(Rgb(color[0], color[1], color[2])));
      if (!m_seen[p] || reflects < kDarkest || !(is > 0)) continue;
      const ChartPlace at = chartPatchPlace(p);
      const Eigen::Vector3d terms(at.x - .5, at.y - .5, 1);
      normal += m_weights[p] * terms * terms.transpose();
      right += m_weights[p] * std::log(is / reflects) * terms;
    }
    const Eigen::VectorXd change = solveSymmetric(normal, right);
    if (!change.allFinite()) return 0;
    m_field += change.head<2>();
    return change.head<2>().cwiseAbs().maxCoeff();
  }

  [[nodiscard]] bool hasMatrix() const { return m_light.minCoeff() > kFaintest * m_light.maxCoeff(); }

  [[nodiscard]] PatchFit fitOf(size_t p) const {
    PatchFit fit;
    fit.clipped = !m_seen[p];
    fit.outlier = m_seen[p] && hasMatrix() && m_weights[p] < kOutlier;
    if (fit.clipped) return fit;
    const auto difference = [&](const Eigen::Vector3d& color) {
      const Eigen::Vector3d truth = reflected(p);
      return deltaE2000(labFromLinearRec709(color[0], color[1], color[2]),
                        labFromLinearRec709(truth[0], truth[1], truth[2]));
    };
    const Eigen::Vector3d plain = balanced(p), color = m_matrix * plain;
    fit.color = {color[0], color[1], color[2]};
    fit.deltaE = difference(color);
    fit.balanced = difference(plain);
    return fit;
  }

  [[nodiscard]] ChartFit result() const {
    ChartFit fit;
    fit.light = {m_light[0], m_light[1], m_light[2]};
    fit.lightError = {m_lightError[0], m_lightError[1], m_lightError[2]};
    fit.across = std::expm1(m_field[0]);
    fit.down = std::expm1(m_field[1]);
    if (hasMatrix()) {
      fit.matrix.emplace();
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) (*fit.matrix)[size_t(i)][size_t(j)] = m_matrix(i, j);
    }
    double count = 0;
    for (size_t p = 0; p < kChartPatches; ++p) {
      fit.patches[p] = fitOf(p);
      if (fit.patches[p].clipped) continue;
      ++count;
      fit.meanDeltaE += fit.patches[p].deltaE;
      fit.meanBalanced += fit.patches[p].balanced;
      fit.mostDeltaE = std::max(fit.mostDeltaE, fit.patches[p].deltaE);
    }
    fit.meanDeltaE /= count;
    fit.meanBalanced /= count;
    return fit;
  }

  const ChartReading& m_reading;
  std::array<bool, kChartPatches> m_seen{};
  Weights m_weights{};
  Eigen::Vector3d m_light{1, 1, 1}, m_lightError{0, 0, 0};
  Eigen::Vector2d m_field{0, 0};
  Eigen::Matrix3d m_matrix = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d m_camera = Eigen::Matrix3d::Identity();  ///< its inverse: greys are not quite neutral
};

}  // namespace

Rgb throughCamera(const CameraMatrix& matrix, const Rgb& balanced) {
  Rgb out(0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out[i] += float(matrix[size_t(i)][size_t(j)]) * balanced[j];
  return out;
}

ChartFit fitChart(const ChartReading& reading) {
  ChartFit fit = ChartSolver(reading).solve();
  fit.warnings = chartWarnings(fit);
  return fit;
}

Json jsonFromChartFit(const ChartFit& fit) {
  const auto three = [](const Rgb& color) { return Json{color.r, color.g, color.b}; };
  Json patches = Json::array();
  for (size_t p = 0; p < kChartPatches; ++p)
    patches.push_back({{"name", chartPatchName(p)},
                       {"color", three(fit.patches[p].color)},
                       {"delta_e", fit.patches[p].deltaE},
                       {"balanced", fit.patches[p].balanced},
                       {"clipped", fit.patches[p].clipped},
                       {"outlier", fit.patches[p].outlier}});
  Json matrix = nullptr;
  if (fit.matrix) matrix = *fit.matrix;
  return {{"light", three(fit.light)},
          {"light_error", three(fit.lightError)},
          {"camera_matrix", matrix},
          {"delta_e", {{"mean", fit.meanDeltaE}, {"most", fit.mostDeltaE}, {"balanced", fit.meanBalanced}}},
          {"unevenness", {{"across", fit.across}, {"down", fit.down}}},
          {"patches", patches},
          {"warnings", fit.warnings}};
}

}  // namespace swaplight
