#include "core/solve/causes/cause_evidence.h"

#include <algorithm>

#include "core/solve/causes/cause_comparison.h"
#include "core/solve/causes/cause_rules.h"

namespace swaplight {

MisfitCauses misfitCauses(const EstimatorContext& context, const ShotSignal& signal,
                          const CauseTuning& tuning) {
  const std::optional<CauseComparison> comparison = CauseComparison::of(context, signal, tuning);
  return comparison ? causesOf(*comparison, tuning) : MisfitCauses();
}

MisfitCauses causesOf(const CauseComparison& comparison, const CauseTuning& tuning) {
  MisfitCauses causes;
  causes.all = comparison.fitted(tuning);
  const bool matters = std::ranges::any_of(causes.all, [&](const CauseEvidence& one) {
    return one.explained > limitsOf(one.cause, tuning).explained;
  });
  if (!matters) return causes;
  comparison.compare(causes.all, tuning);
  causes.likely = likelyCauses(causes.all, comparison.context(), comparison.blocks(), tuning);
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
