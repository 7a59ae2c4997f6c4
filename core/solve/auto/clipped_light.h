#pragma once

#include <cstddef>

#include "core/set/solved_set.h"
#include "core/solve/auto/auto_tuning.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// Tells the lights apart in pixels that are clipped in so many shots that what is left determines no light
/// for itself. There a clipped value is a lower bound and no measurement: taken for one, it makes all lights
/// alike, and a highlight of one light shines on when that light is turned off. Sought are the contributions
/// T >= 0 of a channel that minimise
///
///   sum over usable shots of (a_k T - y_k)^2 / var_k  +  sum over clipped ones of max(0, y_k - a_k T)^2 /
///   var_k
///   + |T - b (b T) / (b b)|^2 / (spread s)^2
///
/// with the proportions b of the neighbours that are not so clipped (push-pull), from which the pixel's own
/// may stray by `spread` of its light s: censored least squares (after Tobin 1958) with a prior, by
/// coordinate descent. Where nothing but bounds is known that is the least light in the neighbours'
/// proportions that clips as it did: highlights keep their light's colour, and their height is what is
/// certain of it.
///
/// Sets contributions, the flag kFilled and sigma of these pixels (not beta); returns how many there were.
/// Where each light was photographed alone its photograph remains its contribution (separatedPart).
size_t restoreClippedLight(const EstimatorContext& context, const ShotSignal& signal,
                           const ClippedLightTuning& tuning, SolvedSet& set);

}  // namespace swaplight
