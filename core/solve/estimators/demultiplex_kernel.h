#pragma once

#include "core/simd/simd.h"
#include "core/solve/model/pixel_run.h"

namespace swaplight {

/// A channel of Demultiplex: its shots and lights, a plane each (room for whole lanes).
struct DemultiplexRun {
  int lights = 0;
  int shots = 0;
  int count = 0;                   ///< pixels
  const float* inverse = nullptr;  ///< [light][shot]
  const float* in[kMaxShots]{};
  float* out[kMaxLights]{};
};

/// out = inverse in. Values below 0 become 0, or, with `negative` (else null), stay, and it is told whether
/// there may be any.
SWAPLIGHT_DECLARE_KERNEL(demultiplexRun, const DemultiplexRun& run, bool* negative)

}  // namespace swaplight
