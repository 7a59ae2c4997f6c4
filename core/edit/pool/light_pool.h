#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "core/edit/pool/lamp_model.h"
#include "core/edit/pool/light_cone.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// A light on a set, measured from the contributions alone: where its lamp seems to be, the edge of its cone,
/// and what it would give where it does not reach.
struct LightPool {
  LampModel lamp;
  double width = 1;  ///< of what it lights, widths of the picture
  std::optional<LightCone> cone;
  /// What of the light is found outside the cone, over what the cone would give there: 0..kMostBounce.
  double bounce = 0;
  /// The light's ratio to all other lights, a channel a picture, small (32-bit float): known where the light
  /// shines, smoothly continued beyond. Times the other lights it is the light on surfaces that it never
  /// reached: a guess.
  std::array<cv::Mat, 3> ratio;
  /// What it gives at most where it shines, R G B (the 98th percentile): a surface that it never reached, and
  /// on which the others are bright, would not get more.
  std::array<float, 3> most{};
  /// No other light shines: the same of the light itself, without texture.
  bool alone = false;
};

/// `light` is an index of the set's lights. A dark light gives a pool that changes nothing.
[[nodiscard]] LightPool measurePool(const SolvedSet& set, size_t light);

}  // namespace swaplight
