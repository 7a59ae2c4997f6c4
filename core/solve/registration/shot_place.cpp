#include "core/solve/registration/shot_place.h"

#include <algorithm>
#include <cmath>

namespace swaplight {

ShotPlaces::ShotPlaces(const ShotShift& shift, int width, int height)
    : m_width(width),
      m_height(height),
      m_cosine(shift.zoom * std::cos(shift.turn)),
      m_sine(shift.zoom * std::sin(shift.turn)) {
  const double middleX = (width - 1) / 2.0, middleY = (height - 1) / 2.0;
  m_x = float(middleX - (double(m_cosine) * middleX - double(m_sine) * middleY) + double(shift.x));
  m_y = float(middleY - (double(m_sine) * middleX + double(m_cosine) * middleY) + double(shift.y));
}

float ShotPlaces::farthestMove() const {
  return farthestFrom(ShotPlaces({}, m_width, m_height));
}

float ShotPlaces::farthestFrom(const ShotPlaces& other) const {
  float farthest = 0;
  for (const float u : {0.0F, float(m_width - 1)})
    for (const float v : {0.0F, float(m_height - 1)}) {
      const Place place = (*this)(u, v), there = other(u, v);
      farthest = std::max(farthest, std::hypot(place.x - there.x, place.y - there.y));
    }
  return farthest;
}

}  // namespace swaplight
