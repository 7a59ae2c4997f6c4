#pragma once

#include "core/plan/plan_noise.h"

namespace swaplight {

/// What a plan's photographs will tell, before they are taken.
struct PlanForecast {
  Conditioning conditioning;  ///< its advice has what typical pixels that clip ask for, too
  /// Of the matte model and of the full contributions; infinite where that model cannot tell the lights
  /// apart.
  PlanNoise matte, transport;
};

/// Of typicalPixels() under a camera of this noise. `lighting`: the plan's, with its exposure.
[[nodiscard]] PlanForecast planForecast(const LightingMatrix& lighting, const SensorNoise& noise);

}  // namespace swaplight
