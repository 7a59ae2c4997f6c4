#pragma once

#include "core/capture/flat_fields.h"
#include "core/solve/solve.h"

namespace swaplight {

/// solveUneven() of lamps behind polarisers, seen through a filter that is crossed with theirs in some shots:
/// those show the set without its highlights, darker by what matte light loses (crossedPass). They are
/// solved; what the other shots have beyond that is each light's highlight (highlightLight) and is taken out
/// of them; then all shots are of one matte set, are solved together, and the highlights are put back: T = D
/// + S, S in SolvedSet::highlights unless the options leave them out. (Debevec et al. 2000; Ma et al. 2007.)
///
/// The capture must be partly crossed. Throws what solveUneven() does, and InputError: a colour that is
/// unknown, lamps with flat fields, crossed shots that do not tell the lights apart by themselves, or what
/// crossedPass() and highlightLight() refuse.
[[nodiscard]] SolvedSet solveCrossed(const Capture& capture, CapturePixels photographs,
                                     const FlatFields& fields, const SolveOptions& options,
                                     const Progress& progress = {});

}  // namespace swaplight
