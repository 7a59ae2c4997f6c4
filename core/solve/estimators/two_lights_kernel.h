#pragma once

#include "core/simd/simd.h"
#include "core/solve/model/pixel_run.h"

namespace swaplight {

/// The colours of two lights in two shots.
struct TwoLightColors {
  float a[3], b[3];  ///< of light 1 and 2 in shot 1
  float c[3], d[3];  ///< in shot 2
};

/// beta of (5.7) and the matte contributions, in one stream over a run (planes padded to kMostLanes);
/// `published`: the reflectance from shot 1 alone, as in the dissertation.
SWAPLIGHT_DECLARE_KERNEL(closedFormRun, const PixelRun& in, const SolvedRun& out,
                         const TwoLightColors& colors, bool published)

}  // namespace swaplight
