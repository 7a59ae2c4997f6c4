#pragma once

#include <cstddef>
#include <vector>

#include "core/set/solved_set.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// Keeps channels that are clipped in a shot within what is known of them where the others say nearly
/// nothing: a lamp that only clips, and is off in the one shot that does not, would come out as no light at
/// all, or, of a trace of noise or bounced light there, as any brightness.
///
/// - A clipped shot gets what it shows, at least. Where a channel falls short by more than the model's own
///   error it is sought anew, by censored least squares from where it stands (auto/censored_light.h), unless
///   as many shots are not clipped as there are lights: they determine it, and this one was spoilt otherwise.
/// - At exposure 1 it gets no more than a hundred times what a shot that is not clipped gets, unless it shows
///   more: a channel beyond is dimmed to that. Deep gels lie within (1 % in a channel).
/// - One that rests on what is clipped (one lamp at a time) stays, as a bound.
///
/// `exposure`: of each shot, a factor. `modelError`: part of a value by which the model may miss it. Changes
/// contributions, and sigma by as much as they are unsure (not beta); returns how many pixels there were.
size_t keepWithinClippedBounds(const EstimatorContext& context, const std::vector<float>& exposure,
                               const ShotSignal& signal, double modelError, SolvedSet& set);

}  // namespace swaplight
