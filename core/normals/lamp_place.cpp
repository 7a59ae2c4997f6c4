#include "core/normals/lamp_place.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swaplight {

LampRays::LampRays(const LampPlace& place) : m_distance(place.distance) {
  const double azimuth = place.azimuth * std::numbers::pi / 180;
  const double elevation = place.elevation * std::numbers::pi / 180;
  m_direction = {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                 std::cos(elevation) * std::cos(azimuth)};
}

LampRay LampRays::at(double x, double y) const {
  if (!m_distance) return {m_direction};
  const cv::Vec3d way = m_direction * *m_distance - cv::Vec3d(x, y, 0);
  const double length = std::max(cv::norm(way), kNearest);
  return {way / length, std::pow(*m_distance / length, 2)};
}

}  // namespace swaplight
