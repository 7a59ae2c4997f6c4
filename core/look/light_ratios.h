#pragma once

#include <vector>

#include "core/set/solved_set.h"

namespace swaplight {

/// How bright the lights of a set are against each other where they meet, at unit white: what a meter on the
/// set would say of one lamp after the other.
///
/// Of two lights it is the median, over the pixels that both reach, of log2 of the ratio of their luminances:
/// there the surface's reflectance cancels. A light reaches a pixel where it is within three stops of its
/// 95th percentile over the picture: what only its bounced or grazing light reaches is no place to hold a
/// meter. Lights that hardly meet are compared by their means over the picture.
class LightRatios {
 public:
  LightRatios() = default;
  explicit LightRatios(const SolvedSet& set);

  /// Stops of one light over another; 0 for lights that were not measured.
  [[nodiscard]] float stops(size_t light, size_t other) const;

 private:
  size_t m_lights = 0;
  std::vector<float> m_stops;  ///< [light * lights + other]
};

}  // namespace swaplight
