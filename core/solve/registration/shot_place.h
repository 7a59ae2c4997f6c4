#pragma once

#include "core/set/shot_shift.h"

namespace swaplight {

/// Where the pixels of the first shot lie in another, of pictures of one size.
class ShotPlaces {
 public:
  ShotPlaces(const ShotShift& shift, int width, int height);

  struct Place {
    float x, y;  ///< pixels
  };
  [[nodiscard]] Place operator()(float u, float v) const {
    return {m_x + m_cosine * u - m_sine * v, m_y + m_sine * u + m_cosine * v};
  }
  /// How far the corner is displaced that moves farthest, in pixels; or against other places.
  [[nodiscard]] float farthestMove() const;
  [[nodiscard]] float farthestFrom(const ShotPlaces& other) const;

 private:
  int m_width, m_height;
  float m_cosine, m_sine;  ///< with the zoom
  float m_x, m_y;          ///< where the first shot's pixel 0, 0 lies
};

}  // namespace swaplight
