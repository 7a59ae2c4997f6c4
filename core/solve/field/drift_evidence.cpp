#include "core/solve/field/drift_evidence.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/quantile.h"
#include "core/linear/decompositions.h"

namespace swaplight {
namespace {

constexpr double kLeastScale = 1e-10;
constexpr double kSeen = 1e-6;  // of the largest eigenvalue
constexpr int kScaleSteps = 4;

/// Rows of a linear model with several right sides, `each` of them a pixel or a step.
struct Rows {
  Eigen::MatrixXd slopes, values;
  int each = 1;
  std::vector<int> tile;  ///< of each group of rows
  double freedom = 3;     ///< of Student's t
  int tiles = 8;
};

/// Information and pull of all unknowns, robust: Student's t, and the errors of a part of the picture taken
/// for dependent (the factor by which parts differ more than independent rows would).
struct Normal {
  Eigen::MatrixXd information, pull;
};

/// Squared distance of each group, a row's right sides summed.
std::vector<double> squaredLeft(const Rows& rows, const Eigen::MatrixXd& left) {
  std::vector<double> squared(rows.tile.size());
  for (size_t g = 0; g < squared.size(); ++g)
    squared[g] = left.middleRows(Eigen::Index(g) * rows.each, rows.each).squaredNorm();
  return squared;
}

/// How much more the parts of the picture disagree than their rows would by themselves, squared; at least 1.
double dependence(const Rows& rows, const Eigen::MatrixXd& weighted, const Eigen::MatrixXd& left,
                  const Eigen::MatrixXd& information) {
  const auto unknowns = rows.slopes.cols(), sides = rows.values.cols();
  std::vector<Eigen::MatrixXd> pulls(size_t(rows.tiles * rows.tiles), Eigen::MatrixXd::Zero(unknowns, sides));
  for (size_t g = 0; g < rows.tile.size(); ++g) {
    const auto first = Eigen::Index(g) * rows.each;
    pulls[size_t(rows.tile[g])].noalias() +=
        weighted.middleRows(first, rows.each).transpose() * left.middleRows(first, rows.each);
  }
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (const Eigen::MatrixXd& pull : pulls) spread.noalias() += pull * pull.transpose() / double(sides);
  const SymmetricEigen eigen = symmetricEigen(information);
  double sum = 0;
  int seen = 0;
  for (Eigen::Index j = 0; j < unknowns; ++j) {
    if (!(eigen.values[j] > kSeen * eigen.values[unknowns - 1])) continue;
    const auto direction = eigen.vectors.col(j);
    sum += direction.dot(spread * direction) / eigen.values[j];
    ++seen;
  }
  return seen > 0 ? std::max(1.0, sum / seen) : 1;
}

Normal robustNormal(const Rows& rows, const Eigen::VectorXd& prior, const FieldTuning& tuning) {
  const double freedom = double(rows.each) * double(rows.values.cols());
  Eigen::MatrixXd unknowns = Eigen::MatrixXd::Zero(rows.slopes.cols(), rows.values.cols());
  Eigen::MatrixXd left = rows.values, weighted = rows.slopes;
  Normal normal;
  double scale = -1;
  for (int pass = 0; pass < tuning.passes; ++pass) {
    const std::vector<double> squared = squaredLeft(rows, left);
    if (scale < 0) {
      std::vector<double> order = squared;
      scale = std::max(median(std::span(order)) / freedom, kLeastScale);
    }
    const auto weightOf = [&](double square) {
      return (rows.freedom + freedom) / (rows.freedom + square / scale);
    };
    for (int step = 0; step < kScaleSteps; ++step) {
      double sum = 0;
      for (const double square : squared) sum += square * weightOf(square);
      scale = std::max(sum / (freedom * double(squared.size())), kLeastScale);
    }
    for (size_t g = 0; g < squared.size(); ++g) {
      const auto first = Eigen::Index(g) * rows.each;
      weighted.middleRows(first, rows.each) =
          weightOf(squared[g]) / scale * rows.slopes.middleRows(first, rows.each);
    }
    normal.information.noalias() = weighted.transpose() * rows.slopes;
    normal.pull.noalias() = weighted.transpose() * rows.values;
    const double factor = dependence(rows, weighted, left, normal.information);
    normal.information /= factor;
    normal.pull /= factor;
    Eigen::MatrixXd known = normal.information;
    known.diagonal() += prior.cwiseAbs2().cwiseInverse();
    unknowns = solveSymmetric(known, normal.pull);
    left = rows.values - rows.slopes * unknowns;
  }
  return normal;
}

/// What is left of the first unknowns when the others, with their prior, are integrated out.
Normal marginal(const Normal& all, Eigen::Index first, const Eigen::VectorXd& prior) {
  const Eigen::Index others = all.information.cols() - first;
  if (others == 0) return all;
  Eigen::MatrixXd inner = all.information.bottomRightCorner(others, others);
  inner.diagonal() += prior.tail(others).cwiseAbs2().cwiseInverse();
  Eigen::MatrixXd right(others, first + all.pull.cols());
  right << all.information.bottomLeftCorner(others, first), all.pull.bottomRows(others);
  const Eigen::MatrixXd solved = solveSymmetric(inner, right);
  const auto mixed = all.information.topRightCorner(first, others);
  return {all.information.topLeftCorner(first, first) - mixed * solved.leftCols(first),
          all.pull.topRows(first) - mixed * solved.rightCols(all.pull.cols())};
}

/// Channels that some lamp has in some shot. Of the others no reflectance is seen, and it explains nothing.
int litChannels(const LightingMatrix& lighting) {
  int lit = 0;
  for (int c = 0; c < 3; ++c)
    lit += std::any_of(lighting.colors.begin(), lighting.colors.end(),
                       [&](const Rgb& color) { return color[c] > 0; });
  return lit;
}

/// What the unknowns of drift, and then a relative error of every colour, do to a pixel's values.
Eigen::MatrixXd matteSlopes(const DriftSample& sample, const PixelMisfit& pixel, int p) {
  const LightingMatrix& lighting = sample.lighting();
  const int drifts = LampDrift::kTerms * LampDrift::kChromas * lighting.lights;
  Eigen::MatrixXd change =
      Eigen::MatrixXd::Zero(3 * lighting.shots, drifts + 3 * lighting.shots * lighting.lights);
  for (int k = 0; k < lighting.shots; ++k)
    for (int i = 0; i < lighting.lights; ++i)
      for (int c = 0; c < 3; ++c) {
        const double light = double(lighting.color(k, i)[c] * pixel.share[size_t(i)] * pixel.reflectance[c]);
        for (int t = 0; t < LampDrift::kTerms; ++t)
          for (int a = 0; a < LampDrift::kChromas; ++a)
            change(3 * k + c, LampDrift::at(i, t, a)) = light * sample.terms(p)[t] * LampDrift::chroma(a, c);
        change(3 * k + c, drifts + (k * lighting.lights + i) * 3 + c) = light;
      }
  return change;
}

}  // namespace

DriftEvidence matteEvidence(const DriftSample& sample, const FieldTuning& tuning) {
  const LightingMatrix& lighting = sample.lighting();
  const Eigen::Index drifts = LampDrift::kTerms * LampDrift::kChromas * lighting.lights;
  const Eigen::Index unknowns = drifts + 3 * lighting.shots * lighting.lights;
  Rows rows;
  rows.each = 3 * lighting.shots - lighting.lights - litChannels(lighting) + 1;
  rows.freedom = tuning.matteFreedom;
  rows.tiles = tuning.tiles;
  const auto most = std::max<size_t>(size_t(tuning.work / double(unknowns * rows.each)), 1);
  const size_t every = std::max<size_t>((size_t(sample.count()) + most - 1) / most, 1);
  const Eigen::Index groups = (sample.count() + Eigen::Index(every) - 1) / Eigen::Index(every);
  rows.slopes = Eigen::MatrixXd::Zero(groups * rows.each, unknowns);
  rows.values = Eigen::MatrixXd::Zero(groups * rows.each, 1);
  Eigen::Index used = 0;
  for (int p = 0; p < sample.count(); p += int(every)) {
    const PixelMisfit pixel = sample.misfit(p);
    // A pixel that one lamp alone lights has more directions free: what they show is no drift.
    if (pixel.residual.size() != rows.each || !pixel.residual.allFinite()) continue;
    rows.slopes.middleRows(used * rows.each, rows.each) = pixel.visible(matteSlopes(sample, pixel, p));
    rows.values.middleRows(used * rows.each, rows.each) = pixel.residual;
    rows.tile.push_back(sample.tile(p));
    ++used;
  }
  if (used == 0) return {Eigen::MatrixXd::Zero(drifts, drifts), Eigen::VectorXd::Zero(drifts)};
  rows.slopes.conservativeResize(used * rows.each, unknowns);
  rows.values.conservativeResize(used * rows.each, 1);
  Eigen::VectorXd prior(unknowns);
  prior << Eigen::VectorXd::Constant(drifts, tuning.drift),
      Eigen::VectorXd::Constant(unknowns - drifts, tuning.colors);
  const Normal found = marginal(robustNormal(rows, prior, tuning), drifts, prior);
  return {found.information, found.pull.col(0)};
}

DriftEvidence surfaceEvidence(const DriftSample& sample, const FieldTuning& tuning) {
  const int lights = sample.lights();
  const Eigen::Index own = LampDrift::kTerms, features = Eigen::Index(LampDrift::kTerms) * lights;
  const auto steps = Eigen::Index(sample.neighbours().size());
  const Eigen::Index drifts = features * LampDrift::kChromas;
  DriftEvidence evidence{Eigen::MatrixXd::Zero(drifts, drifts), Eigen::VectorXd::Zero(drifts)};
  if (steps == 0) return evidence;
  Rows rows;
  rows.freedom = tuning.stepFreedom;
  rows.tiles = tuning.tiles;
  rows.slopes.resize(steps, features + own);
  rows.values.resize(steps, LampDrift::kChromas);
  for (Eigen::Index s = 0; s < steps; ++s) {
    const auto [from, to] = sample.neighbours()[size_t(s)];
    const double noise = .5 * (sample.hueVariance(from) + sample.hueVariance(to));
    const double weight = tuning.texture / std::sqrt(noise + tuning.texture * tuning.texture);
    for (int i = 0; i < lights; ++i)
      rows.slopes.block(s, own * i, 1, own) =
          weight *
          (sample.share(to, i) * sample.terms(to) - sample.share(from, i) * sample.terms(from)).transpose();
    rows.slopes.block(s, features, 1, own) = weight * (sample.terms(to) - sample.terms(from)).transpose();
    const std::array<double, 3> a = sample.hue(from), b = sample.hue(to);
    for (int chroma = 0; chroma < LampDrift::kChromas; ++chroma) {
      double step = 0;
      for (int c = 0; c < 3; ++c) step += LampDrift::chroma(chroma, c) * (b[size_t(c)] - a[size_t(c)]);
      rows.values(s, chroma) = weight * step;
    }
    rows.tile.push_back(sample.tile(from));
  }
  Eigen::VectorXd prior(features + own);
  prior << Eigen::VectorXd::Constant(features, tuning.drift),
      Eigen::VectorXd::Constant(own, tuning.reflectance);
  const Normal found = marginal(robustNormal(rows, prior, tuning), features, prior);
  for (Eigen::Index j = 0; j < features; ++j)
    for (int a = 0; a < LampDrift::kChromas; ++a) {
      evidence.pull[j * LampDrift::kChromas + a] = found.pull(j, a);
      for (Eigen::Index m = 0; m < features; ++m)
        evidence.information(j * LampDrift::kChromas + a, m * LampDrift::kChromas + a) =
            found.information(j, m);
    }
  return evidence;
}

}  // namespace swaplight
