#pragma once

#include <vector>

#include "core/solve/causes/cause_context.h"
#include "core/solve/causes/misfit_sample.h"
#include "core/solve/causes/tone_correction.h"

namespace swaplight {

/// What additivity leaves of a capture's pixels: whatever surfaces do, and whatever colours the gels have,
/// light adds up. So photographs whose lamps depend on each other (a + b beside a and b; with gels swapped
/// among two lamps b_r + r_w + w_b beside b_w + w_r + r_b; the exposures of a bracket, where they are known
/// otherwise than by these pictures) do, too. `share` and
/// `reflectance` of the sample are not given.
struct AdditivitySample {
  std::vector<PixelMisfit> pixels;  ///< none: no photographs that depend on each other
  bool ambientProof = false;        ///< holds under any light, too, that was the same in all of them
};

/// Of about `count` pixels that are neither dark nor flagged, spread evenly over the set, with a curve taken
/// off their values. `exposure`: of each shot, linear.
[[nodiscard]] AdditivitySample additivitySample(const CauseContext& context,
                                                const std::vector<double>& exposure,
                                                const ToneCorrection& tone, int count,
                                                const CauseTuning& tuning);

}  // namespace swaplight
