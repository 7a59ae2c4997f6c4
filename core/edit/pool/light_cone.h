#pragma once

#include <optional>
#include <span>

#include "core/edit/pool/cone_outline.h"

namespace swaplight {

/// The edge of a light's cone in the picture: an ellipse with a soft edge, or what is seen of it. Lengths are
/// widths of the picture, x to the right and y up from its middle.
struct LightCone {
  double x = 0, y = 0;                      ///< the ellipse's middle
  double radiusA = 1, radiusB = 1;          ///< half axes
  double cosine = 1, sine = 0;              ///< of the angle from x to the first axis
  double softness = 0.2;                    ///< the edge's width, in radii
  std::optional<ConeOutline> outline = {};  ///< where there is one it counts, not the ellipse

  double explained = 1;  ///< of what is dark in the picture, by the ellipse: 0.5..1

  /// How well this follows the edge of the cone on the set's surfaces: radii.
  [[nodiscard]] double unsure() const { return outline ? 0.05 : 0.15; }
  /// Of what is lit, in and beyond the picture.
  [[nodiscard]] cv::Point2d middle() const;
  /// Of a disk of the same area, widths of the picture.
  [[nodiscard]] double meanRadius() const;
  /// The edge brought to a radius.
  void setEdge(double radius);

  /// 0 in its middle, 1 at its edge.
  [[nodiscard]] double radius(double px, double py) const;
  /// 0 outside the cone to 1 inside it, at such a radius.
  [[nodiscard]] double atRadius(double radius) const;
  [[nodiscard]] double at(double px, double py) const { return atRadius(radius(px, py)); }
};

/// Light that is found outside a cone, over what the cone would give there, at most: it has bounced.
inline constexpr double kMostBounce = 0.2;

/// How much of the light is at a place of the picture: 0 none, 1 as everywhere where it shines.
struct SeenPixel {
  double x = 0, y = 0;
  double seen = 0;
};

/// The cone that divides where a light shines from where it does not, if there is one: dark nearly everywhere
/// outside, while shadows may lie inside. The pixels are a grid over the picture.
[[nodiscard]] std::optional<LightCone> findCone(std::span<const SeenPixel> pixels);

/// What a cone leaves unexplained: the mean square of what is missing of it, where shadows count less, or is
/// too much.
[[nodiscard]] double unexplainedBy(const LightCone& cone, std::span<const SeenPixel> pixels);

}  // namespace swaplight
