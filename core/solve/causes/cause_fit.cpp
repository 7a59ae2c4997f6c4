#include "core/solve/causes/cause_fit.h"

#include <algorithm>
#include <cmath>

#include "core/base/quantile.h"
#include "core/linear/decompositions.h"

namespace swaplight {
namespace {

constexpr double kLeastScale = 1e-9;
constexpr int kFirstScaleSteps = 12, kScaleSteps = 3;
constexpr double kSettledScale = 1e-4;  // relative change of a pass

/// Rows of a span's pixels.
struct RowSpan {
  Eigen::Index begin, count;
};

RowSpan rowsOf(const MisfitRows& rows, const PixelSpan& pixels) {
  const Eigen::Index begin = rows.first[size_t(pixels.begin)];
  return {begin, rows.first[size_t(pixels.end)] - begin};
}

double freedomOf(const MisfitRows& rows, int pixel) {
  return double(rows.first[size_t(pixel) + 1] - rows.first[size_t(pixel)]);
}

/// Squared residual of each pixel under the fit.
std::vector<double> squaredLeft(const MisfitRows& rows, const Eigen::MatrixXd& slopes,
                                const PixelSpan& pixels, const Eigen::VectorXd& unknowns) {
  const RowSpan span = rowsOf(rows, pixels);
  Eigen::VectorXd left = rows.residual.segment(span.begin, span.count);
  if (slopes.cols() > 0) left.noalias() -= slopes.middleRows(span.begin, span.count) * unknowns;
  std::vector<double> squared;
  squared.reserve(size_t(pixels.end - pixels.begin));
  for (int p = pixels.begin; p < pixels.end; ++p)
    squared.push_back(
        left.segment(rows.first[size_t(p)] - span.begin, Eigen::Index(freedomOf(rows, p))).squaredNorm());
  return squared;
}

/// Of a squared residual under Student's t.
double weightOf(double squared, double freedom, double squaredScale, double tails) {
  return (tails + freedom) / (tails + squared / squaredScale);
}

double medianScale(const MisfitRows& rows, const PixelSpan& pixels, const std::vector<double>& squared) {
  std::vector<double> each;
  for (size_t j = 0; j < squared.size(); ++j)
    each.push_back(squared[j] / freedomOf(rows, pixels.begin + int(j)));
  return std::max(median(std::span(each)), kLeastScale);
}

/// Nearer by some steps to the most likely scale of squared residuals under Student's t.
double nearerScale(const MisfitRows& rows, const PixelSpan& pixels, const std::vector<double>& squared,
                   double scale, int steps, double tails) {
  const auto freedom = double(rowsOf(rows, pixels).count);
  for (int step = 0; step < steps; ++step) {
    double sum = 0;
    for (size_t j = 0; j < squared.size(); ++j)
      sum += squared[j] * weightOf(squared[j], freedomOf(rows, pixels.begin + int(j)), scale, tails);
    scale = std::max(sum / freedom, kLeastScale);
  }
  return scale;
}

/// Roots of the rows' weights in least squares.
Eigen::VectorXd rootWeights(const MisfitRows& rows, const PixelSpan& pixels,
                            const std::vector<double>& squared, double scale, double tails) {
  const RowSpan span = rowsOf(rows, pixels);
  Eigen::VectorXd roots(span.count);
  for (size_t j = 0; j < squared.size(); ++j) {
    const int p = pixels.begin + int(j);
    const double f = freedomOf(rows, p);
    roots.segment(rows.first[size_t(p)] - span.begin, Eigen::Index(f))
        .setConstant(std::sqrt(weightOf(squared[j], f, scale, tails) / scale));
  }
  return roots;
}

Eigen::VectorXd leastSquaresUnder(const Eigen::VectorXd& roots, const Eigen::MatrixXd& slopes,
                                  const Eigen::VectorXd& residual, double prior) {
  const Eigen::MatrixXd weighted = roots.asDiagonal() * slopes;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(slopes.cols(), slopes.cols());
  normal.selfadjointView<Eigen::Lower>().rankUpdate(weighted.transpose());
  normal = Eigen::MatrixXd(normal.selfadjointView<Eigen::Lower>());
  normal.diagonal().array() += 1 / (prior * prior);
  return solveSymmetric(normal, weighted.transpose() * roots.cwiseProduct(residual));
}

}  // namespace

MisfitRows misfitRows(const std::vector<PixelMisfit>& sample) {
  MisfitRows rows;
  rows.first.push_back(0);
  for (const PixelMisfit& pixel : sample) rows.first.push_back(rows.first.back() + pixel.residual.size());
  rows.residual.resize(rows.first.back());
  for (size_t p = 0; p < sample.size(); ++p)
    rows.residual.segment(rows.first[p], sample[p].residual.size()) = sample[p].residual;
  return rows;
}

CauseFit fitCause(const MisfitRows& rows, const Eigen::MatrixXd& slopes, const PixelSpan& pixels,
                  double prior, const CauseTuning& tuning) {
  CauseFit fit;
  fit.unknowns = Eigen::VectorXd::Zero(slopes.cols());
  if (pixels.begin == pixels.end) return fit;
  const RowSpan span = rowsOf(rows, pixels);
  for (int pass = 0; pass <= tuning.passes; ++pass) {
    const std::vector<double> squared = squaredLeft(rows, slopes, pixels, fit.unknowns);
    const double before = pass == 0 ? medianScale(rows, pixels, squared) : fit.squaredScale;
    fit.squaredScale = nearerScale(rows, pixels, squared, before, pass == 0 ? kFirstScaleSteps : kScaleSteps,
                                   tuning.freedom);
    const bool settled = pass > 0 && std::abs(fit.squaredScale - before) < kSettledScale * before;
    if (slopes.cols() == 0 || pass == tuning.passes || settled) break;
    fit.unknowns = leastSquaresUnder(rootWeights(rows, pixels, squared, fit.squaredScale, tuning.freedom),
                                     slopes.middleRows(span.begin, span.count),
                                     rows.residual.segment(span.begin, span.count), prior);
  }
  return fit;
}

std::vector<double> logLikelihoods(const MisfitRows& rows, const Eigen::MatrixXd& slopes,
                                   const PixelSpan& pixels, const CauseFit& fit, const CauseTuning& tuning) {
  std::vector<double> logs = squaredLeft(rows, slopes, pixels, fit.unknowns);
  for (size_t j = 0; j < logs.size(); ++j) {
    const double f = freedomOf(rows, pixels.begin + int(j));
    logs[j] = -.5 * (tuning.freedom + f) * std::log1p(logs[j] / (tuning.freedom * fit.squaredScale)) -
              .5 * f * std::log(fit.squaredScale);
  }
  return logs;
}

}  // namespace swaplight
