#pragma once

#include <optional>
#include <vector>

#include "core/image/image.h"

namespace swaplight {

/// Where light gathers on the set: the middle of a lamp's pool.
struct LightSink {
  double x = 0, y = 0;    ///< its brightest place, pixels of the picture
  double radius = 0;      ///< pixels: the pool falls off as a Gaussian of this standard deviation
  double stops = 0;       ///< how far it stands out: of a Gaussian pool, from its middle to far away
  double prominence = 0;  ///< stops down from it to where a brighter one begins, or to the darkest place
  double sigmas = 0;      ///< how far it stands out, over its standard error
  /// The brightest place lies at the picture's border: the pool goes on outside, in this direction (a unit
  /// vector, y down).
  struct Direction {
    double x = 0, y = 0;
  };
  std::optional<Direction> outside;
};

/// The pools of a light, most prominent first, from its illumination map (illumination.h): peaks of its
/// logarithm, smoothed over .06 widths of the picture, from which it goes down by 2.5 stops at least (one, of
/// the first), and by five standard errors, before it goes up to a higher one (topological persistence:
/// Edelsbrunner, Letscher and Zomorodian 2002). Breadth and strength are those of the scale at which the
/// normalised Laplacian of Gaussians answers most (Lindeberg 1998). Their number is that of the light's
/// lamps, as far as their pools lie apart; a deep shadow across a pool makes two of it. None where light is
/// even, or there is none.
[[nodiscard]] std::vector<LightSink> findSinks(const Image& map);

/// How many lamps a light has, judged by its pools: even light is some lamp's, too; a dark one has none.
[[nodiscard]] size_t lampCount(const std::vector<LightSink>& sinks, const Image& map);

}  // namespace swaplight
