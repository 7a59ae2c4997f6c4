#include "core/solve/causes/cause_evidence.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/parallel.h"
#include "core/solve/calibration/color_evidence.h"
#include "core/solve/causes/cause_fit.h"
#include "core/solve/causes/cause_slopes.h"
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

/// The sample's pixels by the parts of the picture that they lie in: every other part is fitted to in turn.
struct Tiles {
  std::vector<int> of;  ///< of each pixel: which part, of `count`
  int count = 0;        ///< parts that have pixels
  PixelSpan half[2];    ///< pixels of white parts, and of black ones
  PixelSpan all;
};

/// Puts the pixels of white parts first.
Tiles tilesOf(std::vector<PixelMisfit>& sample, const CapturePixels& pixels, int across) {
  const auto isWhite = [&](const PixelMisfit& pixel) { return tileOf(pixel, pixels, across).isWhite(); };
  const auto black = std::stable_partition(sample.begin(), sample.end(), isWhite);
  Tiles tiles;
  std::vector<int> name(size_t(across) * size_t(across), -1);
  for (const PixelMisfit& pixel : sample) {
    const Tile tile = tileOf(pixel, pixels, across);
    int& named = name[size_t(tile.row) * size_t(across) + size_t(tile.column)];
    if (named < 0) named = tiles.count++;
    tiles.of.push_back(named);
  }
  tiles.all = {0, int(sample.size())};
  tiles.half[0] = {0, int(black - sample.begin())};
  tiles.half[1] = {tiles.half[0].end, tiles.all.end};
  return tiles;
}

/// The log likelihood of every part of the picture under a cause that was fitted to others.
std::vector<double> heldOut(const MisfitRows& rows, const Tiles& tiles, const Eigen::MatrixXd& slopes,
                            double prior, const CauseTuning& tuning) {
  std::vector<double> sums(size_t(tiles.count), 0.0);
  for (int half = 0; half < 2; ++half) {
    const PixelSpan& judged = tiles.half[half];
    const CauseFit fit = fitCause(rows, slopes, tiles.half[1 - half], prior, tuning);
    const std::vector<double> logs = logLikelihoods(rows, slopes, judged, fit, tuning);
    for (size_t j = 0; j < logs.size(); ++j) sums[size_t(tiles.of[size_t(judged.begin) + j])] += logs[j];
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
  const Eigen::MatrixXd level = slopes.middleCols<3>(3).rowwise().sum();
  return fitCause(rows, level, pixels, prior, tuning).unknowns[0];
}

struct Candidate {
  CauseEvidence evidence;
  Eigen::MatrixXd slopes;
  double prior = 1;
  std::vector<double> sums;  ///< of each part of the picture
};

const CauseLimits& limitsOf(Cause cause, const CauseTuning& tuning) {
  switch (cause) {
    case Cause::Ambient:
      return tuning.ambient;
    case Cause::Tone:
      return tuning.tone;
    case Cause::Moved:
      return tuning.moved;
    case Cause::Field:
      return tuning.field;
    case Cause::Colors:
      break;
  }
  return tuning.colors;
}

bool isNamed(const CauseEvidence& evidence, const CauseTuning& tuning) {
  const CauseLimits& least = limitsOf(evidence.cause, tuning);
  const double size = evidence.cause == Cause::Tone ? std::abs(evidence.size) : evidence.size;
  return evidence.explained > least.explained && evidence.certainty > least.certainty && size > least.size;
}

/// Bounced light has colours that the lamps have not, and is in all of a room: to the matte model it looks
/// like wrong colours. But it is light of the lamps: told apart channel by channel, none of it is negative.
/// Where nothing blocks a lamp that cannot be seen, and no colours are said to be wrong.
bool colorsMakeNegativeLight(const EstimatorContext& context, const ShotSignal& signal, double error,
                             const CauseTuning& tuning) {
  const std::optional<float> seen = colorUncertaintyByEvidence(context, signal, float(error));
  // What is seen goes no further than the evidence weighs.
  return seen && double(*seen) > tuning.seenAsNegative * std::min(error, ColorEvidenceTuning{}.largest);
}

/// Ambient light lifts the shadows, as a curve of less contrast does. Where both would explain much, the
/// small difference between their models is no evidence: real ambient light is not as strong everywhere.
bool bothLiftShadows(const CauseEvidence& best, const CauseEvidence& other) {
  const bool tone =
      (best.cause == Cause::Tone && best.size < 0) || (other.cause == Cause::Tone && other.size < 0);
  return tone && (best.cause == Cause::Ambient || other.cause == Cause::Ambient);
}

const CauseEvidence* evidenceOf(Cause cause, const std::vector<CauseEvidence>& all) {
  const auto found = std::ranges::find(all, cause, &CauseEvidence::cause);
  return found == all.end() ? nullptr : &*found;
}

/// Light behind the reflectance cannot be negative. What looks so is shadows that are darker than the lamps
/// leave them: a curve of more contrast, which explains nearly as much.
bool isDarkenedByACurve(const CauseEvidence& ambient, const CauseEvidence& tone) {
  return ambient.cause == Cause::Ambient && ambient.size < 0 && tone.cause == Cause::Tone && tone.size > 0;
}

/// Such a curve, where nothing is surely better than negative light. Wrong colours look like that, too: then
/// they explain far more than a curve does. Bounced light as well: but it makes no light of a lamp negative.
const CauseEvidence* darkeningCurve(const std::vector<CauseEvidence>& all, const EstimatorContext& context,
                                    const ShotSignal& signal, const CauseTuning& tuning) {
  const CauseEvidence* ambient = evidenceOf(Cause::Ambient, all);
  const CauseEvidence* tone = evidenceOf(Cause::Tone, all);
  const CauseEvidence* colors = evidenceOf(Cause::Colors, all);
  if (!ambient || !tone || !colors || !isDarkenedByACurve(*ambient, *tone)) return nullptr;
  const bool near = tone->behind < tuning.farApart || tone->gain > colors->gain;
  const bool may = near && ambient->behind < tuning.apart && isNamed(*tone, tuning);
  if (!may) return nullptr;
  const auto seen = colorUncertaintyByEvidence(context, signal, float(ColorEvidenceTuning{}.largest));
  return seen && double(*seen) > tuning.unnamedColors ? tone : nullptr;
}

/// What bounces goes over the picture less smoothly, hardly at all, or by more than lamps drift.
bool isDriftOfLamps(const CauseEvidence& field, const CauseTuning& tuning) {
  return field.explained >= tuning.beyondBounce ||
         (field.size > tuning.leastDrift && field.size < tuning.mostDrift);
}

/// What the matte model cannot tell from bounced light.
bool mayBeBouncedLight(const CauseEvidence& one, const EstimatorContext& context, const ShotSignal& signal,
                       const CauseTuning& tuning) {
  if (one.cause == Cause::Ambient) return one.size <= 0;
  if (one.cause == Cause::Field && isDriftOfLamps(one, tuning)) return false;
  return (one.cause == Cause::Colors || one.cause == Cause::Field) &&
         !colorsMakeNegativeLight(context, signal, one.size, tuning);
}

/// Ambient light that is more than bounced light ever looks like. Wrong colours have more unknowns and
/// explain it as well, real ambient light, which is not the same everywhere, even a little better.
bool mayBeAmbient(const CauseEvidence& one, const CauseEvidence& best, const CauseTuning& tuning) {
  if (one.cause != Cause::Ambient || one.explained <= tuning.ambient.explained) return false;
  const bool sure = one.certainty > tuning.ambient.certainty;
  if (one.behind < tuning.apart && sure) return one.size > tuning.surelyAmbient;
  const bool likely = one.size < tuning.mostAmbient;
  if (one.behind < tuning.apart)
    return likely && one.certainty > tuning.leastCertainty && one.size > tuning.muchAmbient;
  return likely && sure && one.size > tuning.surelyAmbient && best.cause == Cause::Colors &&
         one.behind < tuning.farApart;
}

/// The best, if it is worth naming; else a curve or ambient light that it may be as well.
const CauseEvidence* worthNaming(const std::vector<CauseEvidence>& all, const EstimatorContext& context,
                                 const ShotSignal& signal, const CauseTuning& tuning) {
  const CauseEvidence& best = all.front();
  if (isNamed(best, tuning) && !mayBeBouncedLight(best, context, signal, tuning)) return &best;
  for (const CauseEvidence& one : all)
    if (mayBeAmbient(one, best, tuning)) return &one;
  return darkeningCurve(all, context, signal, tuning);
}

/// That which is worth naming, and what is not surely worse. `all`: the best first.
std::vector<Cause> likelyCauses(const std::vector<CauseEvidence>& all, const EstimatorContext& context,
                                const ShotSignal& signal, const CauseTuning& tuning) {
  const CauseEvidence* named = worthNaming(all, context, signal, tuning);
  if (!named) return {};
  std::vector<Cause> likely = {named->cause};
  const CauseEvidence* curve = darkeningCurve(all, context, signal, tuning);
  for (const CauseEvidence& one : all) {
    const bool rival = one.behind < tuning.apart || bothLiftShadows(*named, one) || &one == curve;
    if (&one == named || !rival) continue;
    // What is named is no bounced light: then wrong colours that explain as much are none either.
    const bool colors = one.cause == Cause::Colors && named->cause == Cause::Ambient;
    const double least = colors ? tuning.leastCertainty : limitsOf(one.cause, tuning).certainty;
    const bool enough = !colors || one.size > tuning.colors.size;
    if (enough && one.certainty >= least && (colors || !mayBeBouncedLight(one, context, signal, tuning)))
      likely.push_back(one.cause);
  }
  return likely;
}

/// A cause fitted to the whole sample.
Candidate candidateOf(const CauseModel& model, const std::vector<PixelMisfit>& sample, const MisfitRows& rows,
                      double noneScale, const CauseTuning& tuning) {
  const PixelSpan all{0, int(sample.size())};
  Candidate candidate{{.cause = model.cause}, visibleSlopes(model, sample, rows), model.prior, {}};
  const CauseFit fit = fitCause(rows, candidate.slopes, all, model.prior, tuning);
  candidate.evidence.explained = std::clamp(1 - fit.squaredScale / noneScale, 0.0, 1.0);
  candidate.evidence.size = model.cause == Cause::Ambient
                                ? ambientLevel(rows, candidate.slopes, all, model.prior, tuning)
                                : causeSize(model, fit.unknowns, sample);
  return candidate;
}

/// What each cause gains where it was not fitted to; the best first.
void compare(std::vector<Candidate>& candidates, const MisfitRows& rows, const Tiles& tiles,
             const CauseTuning& tuning) {
  const std::vector<double> none = heldOut(rows, tiles, Eigen::MatrixXd(rows.residual.size(), 0), 1, tuning);
  parallelEach(int(candidates.size()), [&](int j) {
    Candidate& candidate = candidates[size_t(j)];
    candidate.sums = heldOut(rows, tiles, candidate.slopes, candidate.prior, tuning);
    const Difference gain = difference(candidate.sums, none);
    candidate.evidence.gain = gain.sum / double(tiles.of.size());
    candidate.evidence.certainty = gain.deviations();
  });
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.evidence.gain > b.evidence.gain; });
  for (Candidate& candidate : candidates)
    candidate.evidence.behind = difference(candidates.front().sums, candidate.sums).deviations();
}

}  // namespace

int causeSampleSize(const EstimatorContext& context, const CauseTuning& tuning) {
  const MatteFit matte(context);
  if (context.lighting.lights < 2 || matte.freedom() < 1) return 0;
  const double cost = double(matte.freedom()) * std::pow(mostCauseUnknowns(context.lighting), 2);
  const int count = int(std::min(double(tuning.pixels), tuning.work / cost));
  return count < tuning.fewestPixels ? 0 : count;
}

MisfitCauses misfitCauses(const EstimatorContext& context, const ShotSignal& signal,
                          const CauseTuning& tuning) {
  MisfitCauses causes;
  const int count = causeSampleSize(context, tuning);
  if (count == 0) return causes;
  std::vector<PixelMisfit> sample = misfitSample(context, signal, count, tuning);
  const Tiles tiles = tilesOf(sample, signal.pixels(), tuning.tiles);
  if (int(sample.size()) < tuning.fewestPixels || tiles.count < tuning.fewestTiles) return causes;

  const MisfitRows rows = misfitRows(sample);
  const Eigen::MatrixXd nothing(rows.residual.size(), 0);
  const double noneScale = fitCause(rows, nothing, tiles.all, 1, tuning).squaredScale;
  const std::vector<CauseModel> models = causeModels(context, signal, sample);
  std::vector<Candidate> candidates(models.size());
  parallelEach(int(models.size()), [&](int j) {
    candidates[size_t(j)] = candidateOf(models[size_t(j)], sample, rows, noneScale, tuning);
  });
  const bool matters = std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& one) {
    return one.evidence.explained > limitsOf(one.evidence.cause, tuning).explained;
  });
  if (matters) compare(candidates, rows, tiles, tuning);
  for (const Candidate& candidate : candidates) causes.all.push_back(candidate.evidence);
  if (matters) causes.likely = likelyCauses(causes.all, context, signal, tuning);
  return causes;
}

bool isSurelyTone(const MisfitCauses& causes, const CauseTuning& tuning) {
  const CauseEvidence* tone = evidenceOf(Cause::Tone, causes.all);
  return causes.is(Cause::Tone) && tone && tone->certainty > tuning.surelyTone &&
         std::ranges::all_of(causes.all, [&](const CauseEvidence& one) {
           const bool worse = one.behind > tuning.apart && one.gain < tone->gain;
           return &one == tone || worse || isDarkenedByACurve(one, *tone);
         });
}

bool isUnnamed(const MisfitCauses& causes, double colorUncertainty, const CauseTuning& tuning) {
  return causes.likely.empty() && colorUncertainty > tuning.unnamedColors &&
         std::ranges::any_of(
             causes.all, [&](const CauseEvidence& one) { return one.explained > tuning.unnamedExplained; });
}

}  // namespace swaplight
