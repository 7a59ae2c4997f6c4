#pragma once

#include "core/capture/flat_fields.h"
#include "core/solve/solve.h"

namespace swaplight {

/// solve() of lamps whose colour changes over the field, and through a lens that darkens the corners. The
/// lights of the result are what even lamps of the colours told, the fields' means, would give.
///
/// shot[k] = sum_i colour[k][i] d[k][i](p) T[i] is solved by taking off what unevenness adds: the shots plus
/// sum_i colour[k][i] (1 - d[k][i]) T[i] are what even lamps would have made of T; T of those is nearer, and
/// again until nothing moves by a thousandth. A field d of +-10 % leaves some hundredths of itself a round.
/// What the lens takes is the same in all shots: the lights are divided by it at the end. Without fields it
/// is solve(), or, with SolveOptions::field, takes those that the photographs show (drift_fit.h).
[[nodiscard]] SolvedSet solveUneven(const Capture& capture, const CapturePixels& photographs,
                                    const FlatFields& fields, const SolveOptions& options,
                                    const Progress& progress = {});

}  // namespace swaplight
