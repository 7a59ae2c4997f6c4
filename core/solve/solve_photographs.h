#pragma once

#include "core/capture/flat_fields.h"
#include "core/solve/solve.h"

namespace swaplight {

/// Photographs as they come out of their files, to lights: a tone curve is taken off where the options ask
/// for it and one is seen (findToneCorrection; the report says which, or that there was none), or where a
/// solve surely shows one (isSurelyTone) and they do not forbid it; solveUneven(), then findHighlights()
/// where the options ask for it; solveCrossed() instead of both where some shots were taken through crossed
/// polarisers. Of photographs that hold only a part of the picture that part is solved, and put where it
/// lies. Throws what these do.
[[nodiscard]] SolvedSet solvePhotographs(const Capture& capture, CapturePixels photographs,
                                         const FlatFields& fields, const SolveOptions& options,
                                         const Progress& progress = {});

}  // namespace swaplight
