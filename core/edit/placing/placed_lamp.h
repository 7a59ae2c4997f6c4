#pragma once

#include <optional>

#include "core/normals/lamp_place.h"

namespace swaplight {

/// Normals of a row of pixels, X Y Z apart, and where it lies: widths of the picture from its middle, to the
/// right and up.
struct NormalRow {
  const float* normal[3];
  float x = 0;     ///< of the first pixel
  float step = 0;  ///< from one to the next
  float y = 0;
};

/// A lamp in a place, and how it shades surfaces.
class PlacedLamp {
 public:
  /// `diameter`: of its front, over its distance. Of a lamp of that size, where half of it stands below a
  /// surface's horizon, the cosine k = sin(atan(diameter / 2)) above and below is (c + k)^2 / 4k: what a line
  /// of light gives there.
  PlacedLamp(const LampPlace& place, double diameter);

  /// Falloff times cosine, of a row of pixels; 1: a surface in the middle of the set that faces the lamp.
  /// Finite, >= 0.
  void shadeRow(const NormalRow& row, int count, float* shade) const;

 private:
  cv::Vec3f m_direction;
  std::optional<float> m_distance;
  float m_soft;
};

}  // namespace swaplight
