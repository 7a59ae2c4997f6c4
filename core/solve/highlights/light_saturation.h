#pragma once

#include <array>
#include <cstddef>

#include "core/set/solved_set.h"
#include "core/solve/model/pixel_run.h"

namespace swaplight {

/// How colourful each light's contribution is at a pixel. A white highlight makes it less so; light that is
/// shed on the same matte surface does not.
struct LightSaturation {
  int lights = 0;
  float error = 0;                        ///< standard error of a contribution's channel
  std::array<float, kMaxLights> mean{};   ///< of the channels
  std::array<float, kMaxLights> color{};  ///< length of what the channels differ from their mean by
  std::array<float, kMaxLights> least{};  ///< the darkest channel

  /// color / mean, and its standard error; 0 and infinity where the light is not seen.
  [[nodiscard]] float of(int light) const;
  [[nodiscard]] float errorOf(int light) const;
  /// The largest that a light has surely, by `sure` standard errors; >= 0.
  [[nodiscard]] float surest(float sure) const;
};

/// Of pixel `p` of a set with quality. `leastError`: of a channel, whatever the solver says.
[[nodiscard]] LightSaturation saturationAt(const SolvedSet& set, size_t p, float leastError);

}  // namespace swaplight
