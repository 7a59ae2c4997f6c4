#include "core/solve/causes/cause_comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"
#include "core/solve/calibration/calibration_tuning.h"
#include "core/solve/estimators/matte_fit.h"

namespace swaplight {
namespace {

/// The part of the picture that a pixel lies in; parts are named like the fields of a chessboard.
struct Tile {
  int column, row;
  [[nodiscard]] bool isWhite() const { return (column + row) % 2 == 0; }
};

Tile tileOf(const PixelMisfit& pixel, const CapturePixels& pixels, int across) {
  return {pixel.x * across / pixels.width(), pixel.y * across / pixels.height()};
}

/// Puts the pixels of white parts first.
PictureParts partsOf(std::vector<PixelMisfit>& sample, const CapturePixels& pixels, int across) {
  const auto isWhite = [&](const PixelMisfit& pixel) { return tileOf(pixel, pixels, across).isWhite(); };
  const auto black = std::stable_partition(sample.begin(), sample.end(), isWhite);
  PictureParts parts;
  std::vector<int> name(size_t(across) * size_t(across), -1);
  for (const PixelMisfit& pixel : sample) {
    const Tile tile = tileOf(pixel, pixels, across);
    int& named = name[size_t(tile.row) * size_t(across) + size_t(tile.column)];
    if (named < 0) named = parts.count++;
    parts.of.push_back(named);
  }
  parts.all = {0, int(sample.size())};
  parts.half[0] = {0, int(black - sample.begin())};
  parts.half[1] = {parts.half[0].end, parts.all.end};
  return parts;
}

/// The log likelihood of every part of the picture under a cause that was fitted to others.
std::vector<double> heldOut(const MisfitRows& rows, const PictureParts& parts, const Eigen::MatrixXd& slopes,
                            double prior, const CauseTuning& tuning) {
  std::vector<double> sums(size_t(parts.count), 0.0);
  for (int half = 0; half < 2; ++half) {
    const PixelSpan& judged = parts.half[half];
    const CauseFit fit = fitCause(rows, slopes, parts.half[1 - half], prior, tuning);
    const std::vector<double> logs = logLikelihoods(rows, slopes, judged, fit, tuning);
    for (size_t j = 0; j < logs.size(); ++j) sums[size_t(parts.of[size_t(judged.begin) + j])] += logs[j];
  }
  return sums;
}

/// A sum over the parts of the picture, and its standard error.
struct Difference {
  double sum = 0, error = 0;
  [[nodiscard]] double deviations() const { return error > 0 ? sum / error : 0; }
};

Difference difference(const std::vector<double>& a, const std::vector<double>& b) {
  const auto count = double(a.size());
  double sum = 0, squares = 0;
  for (size_t j = 0; j < a.size(); ++j) {
    sum += a[j] - b[j];
    squares += (a[j] - b[j]) * (a[j] - b[j]);
  }
  return {sum, std::sqrt(std::max(squares - sum * sum / count, 0.0) * count / std::max(count - 1, 1.0))};
}

/// Ambient light that is white and as strong everywhere, over the median pixel's light: the other unknowns of
/// the Ambient model cannot be told from the lamps' own light.
double ambientLevel(const MisfitRows& rows, const Eigen::MatrixXd& slopes, const PixelSpan& pixels,
                    double prior, const CauseTuning& tuning) {
  return fitCause(rows, evenAmbientSlope(slopes), pixels, prior, tuning).unknowns[0];
}

}  // namespace

std::optional<CauseComparison> CauseComparison::of(const EstimatorContext& context, const ShotSignal& signal,
                                                   const CauseTuning& tuning) {
  const int count = causeSampleSize(context, tuning);
  if (count == 0) return std::nullopt;
  return of(context, signal, misfitSample(context, signal, count, tuning),
            blockMeans(signal, context.lighting.shots, ColorEvidenceTuning{}.blocks), tuning);
}

std::optional<CauseComparison> CauseComparison::with(const PlacedPixels& pixels,
                                                     std::vector<BlockMean> blocks,
                                                     const CauseTuning& tuning) const {
  return of(*m_context, *m_signal, misfitSample(*m_context, *m_signal, pixels, tuning), std::move(blocks),
            tuning);
}

std::optional<CauseComparison> CauseComparison::of(const EstimatorContext& context, const ShotSignal& signal,
                                                   std::vector<PixelMisfit> sample,
                                                   std::vector<BlockMean> blocks, const CauseTuning& tuning) {
  if (int(sample.size()) < tuning.fewestPixels) return std::nullopt;
  CauseComparison comparison(context, signal, std::move(sample), std::move(blocks), tuning);
  if (comparison.m_parts.count < tuning.fewestTiles) return std::nullopt;
  return comparison;
}

CauseComparison::CauseComparison(const EstimatorContext& context, const ShotSignal& signal,
                                 std::vector<PixelMisfit> sample, std::vector<BlockMean> blocks,
                                 const CauseTuning& tuning)
    : m_context(&context), m_signal(&signal), m_sample(std::move(sample)), m_blocks(std::move(blocks)) {
  m_parts = partsOf(m_sample, signal.pixels(), tuning.tiles);
  m_rows = misfitRows(m_sample);
  m_models = causeModels(context, signal, m_sample);
  m_slopes.resize(m_models.size());
  parallelEach(int(m_models.size()),
               [&](int j) { m_slopes[size_t(j)] = visibleSlopes(m_models[size_t(j)], m_sample, m_rows); });
}

size_t CauseComparison::indexOf(Cause cause) const {
  return size_t(std::ranges::find(m_models, cause, &CauseModel::cause) - m_models.begin());
}

Eigen::VectorXd CauseComparison::unknownsOf(Cause cause, const CauseTuning& tuning) const {
  const size_t j = indexOf(cause);
  return fitCause(m_rows, m_slopes[j], m_parts.all, m_models[j].prior, tuning).unknowns;
}

std::vector<CauseEvidence> CauseComparison::fitted(const CauseTuning& tuning) const {
  const Eigen::MatrixXd nothing(m_rows.residual.size(), 0);
  const double noneScale = fitCause(m_rows, nothing, m_parts.all, 1, tuning).squaredScale;
  std::vector<CauseEvidence> causes(m_models.size());
  parallelEach(int(m_models.size()), [&](int j) {
    const CauseModel& model = m_models[size_t(j)];
    CauseEvidence& evidence = causes[size_t(j)];
    evidence.cause = model.cause;
    const CauseFit fit = fitCause(m_rows, m_slopes[size_t(j)], m_parts.all, model.prior, tuning);
    evidence.explained = std::clamp(1 - fit.squaredScale / noneScale, 0.0, 1.0);
    evidence.size = model.cause == Cause::Ambient
                        ? ambientLevel(m_rows, m_slopes[size_t(j)], m_parts.all, model.prior, tuning)
                        : causeSize(model, fit.unknowns, m_sample);
  });
  return causes;
}

void CauseComparison::compare(std::vector<CauseEvidence>& causes, const CauseTuning& tuning) const {
  const std::vector<double> none =
      heldOut(m_rows, m_parts, Eigen::MatrixXd(m_rows.residual.size(), 0), 1, tuning);
  std::vector<std::vector<double>> sums(m_models.size());  // of each part of the picture
  parallelEach(int(m_models.size()), [&](int j) {
    sums[size_t(j)] = heldOut(m_rows, m_parts, m_slopes[size_t(j)], m_models[size_t(j)].prior, tuning);
  });
  for (CauseEvidence& one : causes) {
    const Difference gain = difference(sums[indexOf(one.cause)], none);
    one.gain = gain.sum / double(m_parts.of.size());
    one.certainty = gain.deviations();
  }
  std::ranges::sort(causes, std::greater<>(), &CauseEvidence::gain);
  for (CauseEvidence& one : causes)
    one.behind = difference(sums[indexOf(causes.front().cause)], sums[indexOf(one.cause)]).deviations();
}

int causeSampleSize(const EstimatorContext& context, const CauseTuning& tuning) {
  const MatteFit matte(context);
  if (context.lighting.lights < 2 || matte.freedom() < 1) return 0;
  const double cost = double(matte.freedom()) * std::pow(mostCauseUnknowns(context.lighting), 2);
  const int count = int(std::min(double(tuning.pixels), tuning.work / cost));
  return count < tuning.fewestPixels ? 0 : count;
}

}  // namespace swaplight
