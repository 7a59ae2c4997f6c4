#pragma once

#include <optional>
#include <span>

namespace swaplight {

/// The edge of a light's cone in the picture: an ellipse with a soft edge. Lengths are widths of the picture,
/// x to the right and y up from its middle.
struct LightCone {
  double x = 0, y = 0;              ///< its middle
  double radiusA = 1, radiusB = 1;  ///< half axes
  double cosine = 1, sine = 0;      ///< of the angle from x to the first axis
  double softness = 0.2;            ///< the edge's width, in radii
  /// An ellipse follows the edge of a cone on a set's surfaces so well: radii.
  static constexpr double kUnsure = 0.15;

  /// 0 in its middle, 1 at its edge.
  [[nodiscard]] double radius(double px, double py) const;
  /// 0 outside the cone to 1 inside it, at such a radius.
  [[nodiscard]] double atRadius(double radius) const;
  [[nodiscard]] double at(double px, double py) const { return atRadius(radius(px, py)); }
};

/// How much of the light is at a place of the picture: 0 none, 1 as everywhere where it shines.
struct SeenPixel {
  double x = 0, y = 0;
  double seen = 0;
};

/// The cone that divides where a light shines from where it does not, if there is one: dark nearly everywhere
/// outside, while shadows may lie inside. The pixels are a grid over the picture.
[[nodiscard]] std::optional<LightCone> findCone(std::span<const SeenPixel> pixels);

}  // namespace swaplight
