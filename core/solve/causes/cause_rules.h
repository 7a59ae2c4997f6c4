#pragma once

#include <vector>

#include "core/set/misfit_cause.h"
#include "core/solve/calibration/block_misfit.h"
#include "core/solve/causes/cause_tuning.h"
#include "core/solve/model/estimator.h"

namespace swaplight {

[[nodiscard]] const CauseLimits& limitsOf(Cause cause, const CauseTuning& tuning);

/// nullptr where it is not among them.
[[nodiscard]] const CauseEvidence* evidenceOf(Cause cause, const std::vector<CauseEvidence>& all);

/// Light behind the reflectance cannot be negative. What looks so is shadows that are darker than the lamps
/// leave them: a curve of more contrast, which explains nearly as much.
[[nodiscard]] bool isDarkenedByACurve(const CauseEvidence& ambient, const CauseEvidence& tone);

/// That which is worth naming, and what is not surely worse. `all`: the best first. `blocks`: of the
/// photographs, in which negative light is looked for.
[[nodiscard]] std::vector<Cause> likelyCauses(const std::vector<CauseEvidence>& all,
                                              const EstimatorContext& context,
                                              const std::vector<BlockMean>& blocks,
                                              const CauseTuning& tuning);

}  // namespace swaplight
