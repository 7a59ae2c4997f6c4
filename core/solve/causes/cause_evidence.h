#pragma once

#include "core/set/misfit_cause.h"
#include "core/solve/causes/cause_tuning.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

class CauseComparison;

/// Why the photographs do not fit the matte model: each cause is fitted to a sample of pixels whose own
/// unknowns (beta, rho) are projected out, and held against the others by the likelihood of parts of the
/// picture that it was not fitted to. So a cause with many unknowns gains nothing by them, and what is in one
/// place only (gloss, bounced light) counts as one place. The differences between two causes, summed a part,
/// give the standard error of their sum (Vuong 1989, for models of which none contains the other).
///
/// The best is likely where it explains enough of the misfit, is surely better than none and large enough
/// (CauseTuning), and with it what is not surely worse. Colours that are wrong or drift count only where they
/// make some light negative, ambient light only where it is not negative: else it is bounced light. Where
/// ambient light is negative and the best, or not surely worse, the curve is named that darkens shadows.
/// Where colours are the best and do not count, ambient light does that is too much to be bounced light,
/// though it be a little worse, for real ambient light is not the same everywhere; and then the colours with
/// it. Where no cause explains enough they are not held against each other: CauseEvidence has `explained` and
/// `size` only. `context.noise`: that of the pixels' own. Empty where the model leaves no freedom, the set is
/// small or the capture so large that comparing would take longer than solving.
[[nodiscard]] MisfitCauses misfitCauses(const EstimatorContext& context, const ShotSignal& signal,
                                        const CauseTuning& tuning = {});

[[nodiscard]] MisfitCauses causesOf(const CauseComparison& comparison, const CauseTuning& tuning);

/// Whether it is a tone curve beyond doubt: the one likely cause, surer than what is only said, and all
/// others surely worse, but for negative ambient light, which is none. Ambient light of a glossy set has been
/// taken for a curve with less.
[[nodiscard]] bool isSurelyTone(const MisfitCauses& causes, const CauseTuning& tuning = {});

/// Whether something is wrong all the same where none is likely: `colorUncertainty` is what the photographs
/// make of the colours' error (color_evidence.h).
[[nodiscard]] bool isUnnamed(const MisfitCauses& causes, double colorUncertainty,
                             const CauseTuning& tuning = {});

}  // namespace swaplight
