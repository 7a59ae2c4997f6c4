#include "core/solve/causes/cause_rules.h"

#include <algorithm>
#include <cmath>

#include "core/solve/calibration/color_evidence.h"

namespace swaplight {
namespace {

bool isNamed(const CauseEvidence& evidence, const CauseTuning& tuning) {
  const CauseLimits& least = limitsOf(evidence.cause, tuning);
  const double size = evidence.cause == Cause::Tone ? std::abs(evidence.size) : evidence.size;
  return evidence.explained > least.explained && evidence.certainty > least.certainty && size > least.size;
}

/// Bounced light has colours that the lamps have not, and is in all of a room: to the matte model it looks
/// like wrong colours. But it is light of the lamps: told apart channel by channel, none of it is negative.
/// Where nothing blocks a lamp that cannot be seen, and no colours are said to be wrong.
bool colorsMakeNegativeLight(const EstimatorContext& context, const std::vector<BlockMean>& blocks,
                             double error, const CauseTuning& tuning) {
  const std::optional<float> seen = colorUncertaintyByEvidence(context, blocks, float(error));
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

/// Such a curve, where nothing is surely better than negative light. Wrong colours look like that, too: then
/// they explain far more than a curve does. Bounced light as well: but it makes no light of a lamp negative.
const CauseEvidence* darkeningCurve(const std::vector<CauseEvidence>& all, const EstimatorContext& context,
                                    const std::vector<BlockMean>& blocks, const CauseTuning& tuning) {
  const CauseEvidence* ambient = evidenceOf(Cause::Ambient, all);
  const CauseEvidence* tone = evidenceOf(Cause::Tone, all);
  const CauseEvidence* colors = evidenceOf(Cause::Colors, all);
  if (!ambient || !tone || !colors || !isDarkenedByACurve(*ambient, *tone)) return nullptr;
  const bool near = tone->behind < tuning.farApart || tone->gain > colors->gain;
  const bool may = near && ambient->behind < tuning.apart && isNamed(*tone, tuning);
  if (!may) return nullptr;
  const auto seen = colorUncertaintyByEvidence(context, blocks, float(ColorEvidenceTuning{}.largest));
  return seen && double(*seen) > tuning.unnamedColors ? tone : nullptr;
}

/// What bounces goes over the picture less smoothly, hardly at all, or by more than lamps drift.
bool isDriftOfLamps(const CauseEvidence& field, const CauseTuning& tuning) {
  return field.explained >= tuning.beyondBounce ||
         (field.size > tuning.leastDrift && field.size < tuning.mostDrift);
}

/// What the matte model cannot tell from bounced light.
bool mayBeBouncedLight(const CauseEvidence& one, const EstimatorContext& context,
                       const std::vector<BlockMean>& blocks, const CauseTuning& tuning) {
  if (one.cause == Cause::Ambient) return one.size <= 0;
  if (one.cause == Cause::Field && isDriftOfLamps(one, tuning)) return false;
  return (one.cause == Cause::Colors || one.cause == Cause::Field) &&
         !colorsMakeNegativeLight(context, blocks, one.size, tuning);
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
                                 const std::vector<BlockMean>& blocks, const CauseTuning& tuning) {
  const CauseEvidence& best = all.front();
  if (isNamed(best, tuning) && !mayBeBouncedLight(best, context, blocks, tuning)) return &best;
  for (const CauseEvidence& one : all)
    if (mayBeAmbient(one, best, tuning)) return &one;
  return darkeningCurve(all, context, blocks, tuning);
}

}  // namespace

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

const CauseEvidence* evidenceOf(Cause cause, const std::vector<CauseEvidence>& all) {
  const auto found = std::ranges::find(all, cause, &CauseEvidence::cause);
  return found == all.end() ? nullptr : &*found;
}

bool isDarkenedByACurve(const CauseEvidence& ambient, const CauseEvidence& tone) {
  return ambient.cause == Cause::Ambient && ambient.size < 0 && tone.cause == Cause::Tone && tone.size > 0;
}

std::vector<Cause> likelyCauses(const std::vector<CauseEvidence>& all, const EstimatorContext& context,
                                const std::vector<BlockMean>& blocks, const CauseTuning& tuning) {
  const CauseEvidence* named = worthNaming(all, context, blocks, tuning);
  if (!named) return {};
  std::vector<Cause> likely = {named->cause};
  const CauseEvidence* curve = darkeningCurve(all, context, blocks, tuning);
  for (const CauseEvidence& one : all) {
    const bool rival = one.behind < tuning.apart || bothLiftShadows(*named, one) || &one == curve;
    if (&one == named || !rival) continue;
    // What is named is no bounced light: then wrong colours that explain as much are none either.
    const bool colors = one.cause == Cause::Colors && named->cause == Cause::Ambient;
    const double least = colors ? tuning.leastCertainty : limitsOf(one.cause, tuning).certainty;
    const bool enough = !colors || one.size > tuning.colors.size;
    if (enough && one.certainty >= least && (colors || !mayBeBouncedLight(one, context, blocks, tuning)))
      likely.push_back(one.cause);
  }
  return likely;
}

}  // namespace swaplight
