#include "core/solve/causes/tone_evidence.h"

#include <algorithm>
#include <cmath>

#include "core/base/quantile.h"
#include "core/solve/causes/cause_fit.h"
#include "core/solve/causes/cause_slopes.h"
#include "core/solve/model/pixel_run.h"

namespace swaplight {
namespace {

constexpr const char* kLeavingOut = "looking whether the photographs hold light";
constexpr int kParts = 4;            // across and down, that are left out in turns
constexpr size_t kFewestParts = 8;   // in fewer a standard error is none
constexpr int kLevels = 33;          // at which a curve is looked at
constexpr double kLevelError = .02;  // of a photograph: lamps flicker, shutters are not exact
constexpr double kMostLevelErrors = 3;

/// A sample, its part of the picture after part, and what a tone curve does to it.
struct ToneRows {
  MisfitRows rows;
  Eigen::MatrixXd slopes;
  Eigen::MatrixXd others;  ///< what else may be wrong, and must not be taken for a curve
  std::vector<PixelSpan> parts;
  double prior = 1;
};

/// What a wrong level of each photograph does to the rows of a sample, in units in which `prior` is
/// kLevelError.
Eigen::MatrixXd levelSlopes(const std::vector<PixelMisfit>& sample, const MisfitRows& rows, double prior) {
  const Eigen::Index shots = sample.empty() ? 0 : sample.front().predicted.size() / 3;
  Eigen::MatrixXd slopes(rows.residual.size(), shots);
  for (size_t p = 0; p < sample.size(); ++p) {
    Eigen::MatrixXd change = Eigen::MatrixXd::Zero(3 * shots, shots);
    for (Eigen::Index row = 0; row < 3 * shots; ++row)
      change(row, row / 3) = kLevelError / prior * sample[p].predicted[row];
    slopes.middleRows(rows.first[p], sample[p].residual.size()) = sample[p].visible(change);
  }
  return slopes;
}

ToneRows toneRows(const CauseContext& context, std::vector<PixelMisfit> sample) {
  const CapturePixels& pixels = context.signal.pixels();
  const auto partOf = [&](const PixelMisfit& pixel) {
    return pixel.y * kParts / pixels.height() * kParts + pixel.x * kParts / pixels.width();
  };
  std::stable_sort(sample.begin(), sample.end(),
                   [&](const PixelMisfit& a, const PixelMisfit& b) { return partOf(a) < partOf(b); });
  ToneRows tone;
  tone.rows = misfitRows(sample);
  for (int p = 0; p < int(sample.size()); ++p) {
    if (tone.parts.empty() || partOf(sample[size_t(p)]) != partOf(sample[size_t(p - 1)]))
      tone.parts.push_back({p, p});
    tone.parts.back().end = p + 1;
  }
  for (const CauseModel& model : causeModels(context.estimator, context.signal, sample))
    if (model.cause == Cause::Tone) {
      tone.slopes = visibleSlopes(model, sample, tone.rows);
      tone.prior = model.prior;
      tone.others = levelSlopes(sample, tone.rows, model.prior);
    }
  return tone;
}

/// All rows but a part's.
ToneRows withoutPart(const ToneRows& all, const PixelSpan& part) {
  const Eigen::Index begin = all.rows.first[size_t(part.begin)], end = all.rows.first[size_t(part.end)];
  const Eigen::Index after = all.rows.residual.size() - end;
  ToneRows rest;
  rest.prior = all.prior;
  rest.rows.residual.resize(begin + after);
  rest.rows.residual << all.rows.residual.head(begin), all.rows.residual.tail(after);
  rest.slopes.resize(begin + after, all.slopes.cols());
  rest.slopes << all.slopes.topRows(begin), all.slopes.bottomRows(after);
  rest.others.resize(begin + after, all.others.cols());
  rest.others << all.others.topRows(begin), all.others.bottomRows(after);
  rest.rows.first.assign(all.rows.first.begin(), all.rows.first.begin() + part.begin + 1);
  for (size_t p = size_t(part.end) + 1; p < all.rows.first.size(); ++p)
    rest.rows.first.push_back(all.rows.first[p] - (end - begin));
  return rest;
}

/// With the first `terms` of the curve; `unknowns` are those.
CauseFit fitTerms(const ToneRows& tone, Eigen::Index terms, const CauseTuning& tuning) {
  Eigen::MatrixXd slopes(tone.slopes.rows(), terms + tone.others.cols());
  slopes << tone.slopes.leftCols(terms), tone.others;
  CauseFit fit = fitCause(tone.rows, slopes, {0, int(tone.rows.first.size()) - 1}, tone.prior, tuning);
  fit.unknowns.conservativeResize(terms);
  return fit;
}

/// Without a curve: what levels leave, unless they would have to be more wrong than levels are.
double squaredScaleWithout(const ToneRows& tone, const CauseTuning& tuning) {
  const PixelSpan all{0, int(tone.rows.first.size()) - 1};
  const CauseFit levels = fitCause(tone.rows, tone.others, all, tone.prior, tuning);
  const double most = levels.unknowns.cwiseAbs().maxCoeff() / tone.prior;
  if (most <= kMostLevelErrors) return levels.squaredScale;
  return fitCause(tone.rows, tone.others.leftCols(0), all, tone.prior, tuning).squaredScale;
}

/// The power of light that a level of every photograph off by kLevelError looks like, RMS.
double exponentOfLevels(const ToneRows& tone) {
  const Eigen::VectorXd exponent = tone.slopes.col(0);
  const double squares = exponent.squaredNorm();
  if (!(squares > 0)) return INFINITY;
  return tone.prior * (tone.others.transpose() * exponent).norm() / squares;
}

/// The values that most of a sample has, evenly in the logarithm.
std::vector<double> levelsOf(const std::vector<PixelMisfit>& sample) {
  std::vector<double> values;
  for (const PixelMisfit& pixel : sample)
    for (const double value : pixel.predicted) values.push_back(value);
  const double low = std::max(quantile(std::span(values), .1), 1e-4);
  const double high = std::max(quantile(std::span(values), .9), 1.1 * low);
  std::vector<double> levels;
  for (int j = 0; j < kLevels; ++j) levels.push_back(low * std::pow(high / low, double(j) / (kLevels - 1)));
  return levels;
}

/// The logarithm of what a curve makes of light, up to exposure.
std::vector<double> departures(const Eigen::VectorXd& unknowns, const std::vector<double>& levels) {
  std::vector<double> gain;
  double mean = 0;
  for (const double level : levels) {
    gain.push_back(toneGain(unknowns, level));
    mean += gain.back() / double(levels.size());
  }
  for (double& one : gain) one -= mean;
  return gain;
}

/// Of what is estimated with parts left out in turns.
double jackknifeError(const std::vector<double>& estimates) {
  double mean = 0, squares = 0;
  const auto count = double(estimates.size());
  for (const double one : estimates) mean += one / count;
  for (const double one : estimates) squares += (one - mean) * (one - mean);
  return std::sqrt(squares * (count - 1) / count);
}

/// How far a power of light is open where the sample cannot show one: one white lamp a photograph is matte
/// again under any power. Parts of the picture agree in that, so that leaving them out does not show it.
double hiddenExponent(const ToneRows& tone, double squaredScale) {
  return 1 / std::sqrt(tone.slopes.col(0).squaredNorm() / squaredScale + 1 / (tone.prior * tone.prior));
}

}  // namespace

Eigen::VectorXd fittedTone(const CauseContext& context, const std::vector<PixelMisfit>& sample,
                           const CauseTuning& tuning) {
  const ToneRows rows = toneRows(context, sample);
  return fitTerms(rows, rows.slopes.cols(), tuning).unknowns;
}

std::optional<ToneEvidence> toneEvidence(const CauseContext& context, const std::vector<PixelMisfit>& sample,
                                         const Progress& progress, const CauseTuning& tuning) {
  if (int(sample.size()) < tuning.fewestPixels) return std::nullopt;
  const ToneRows tone = toneRows(context, sample);
  if (tone.parts.size() < kFewestParts) return std::nullopt;
  const Eigen::Index terms = tone.slopes.cols();
  const CauseFit curve = fitTerms(tone, terms, tuning);
  const std::vector<double> levels = levelsOf(sample);
  const std::vector<double> gain = departures(curve.unknowns, levels);
  const auto most = std::max_element(gain.begin(), gain.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); });
  std::vector<double> exponents, gains;
  for (const PixelSpan& part : tone.parts) {
    progress.update(float(exponents.size()) / float(tone.parts.size()), kLeavingOut);
    const ToneRows rest = withoutPart(tone, part);
    exponents.push_back(fitTerms(rest, 1, tuning).unknowns[0]);
    gains.push_back(departures(fitTerms(rest, terms, tuning).unknowns, levels)[size_t(most - gain.begin())]);
  }
  ToneEvidence evidence;
  const double none = squaredScaleWithout(tone, tuning);
  const double hidden = hiddenExponent(tone, none);
  evidence.exponent = 1 + fitTerms(tone, 1, tuning).unknowns[0];
  evidence.exponentError = std::hypot(jackknifeError(exponents), hidden);
  evidence.departure = std::abs(*most);
  evidence.departureError =
      std::hypot(jackknifeError(gains), hidden * .5 * std::log(levels.back() / levels.front()));
  evidence.explained = std::clamp(1 - curve.squaredScale / none, 0.0, 1.0);
  evidence.misfit = std::sqrt(none);
  evidence.levelError = exponentOfLevels(tone);
  return evidence;
}

}  // namespace swaplight
