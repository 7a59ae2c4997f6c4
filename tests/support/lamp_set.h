#pragma once

#include <cmath>

#include "core/base/json_fwd.h"
#include "core/set/solved_set.h"

namespace swaplight::test {

/// A lamp in front of an upright wall that fills the picture: x to the right, y up from the picture's middle,
/// z from the wall, in widths of the picture.
struct LampPlace {
  double x = 0, y = 0, z = .8;
  double tangent = 0;     ///< of a spot's half angle; 0: a bare lamp
  double panDegrees = 0;  ///< of a spot: to the right
};

/// What it gives to a white wall: n.l / d^2, 1 straight before a lamp at .8.
inline double wallLight(const LampPlace& lamp, double x, double y) {
  const double dx = x - lamp.x;
  const double dy = y - lamp.y;
  const double square = dx * dx + dy * dy + lamp.z * lamp.z;
  const double light = .64 * lamp.z / std::pow(square, 1.5);
  if (lamp.tangent == 0) return light;
  const double angle = lamp.panDegrees * 3.14159265358979 / 180;
  const double along = dx * std::sin(angle) + lamp.z * std::cos(angle);
  const double across = std::hypot(dx * std::cos(angle) - lamp.z * std::sin(angle), dy);
  if (along <= 0) return 0;
  const double t = std::min(std::max((1 - across / along / lamp.tangent) / .1 + .5, 0.), 1.);
  return light * t * t * (3 - 2 * t);
}

/// A wall of small coloured tiles, lit by the lamp ("key") and by another far to the right ("fill").
inline SolvedSet lampSet(int width, int height, const LampPlace& key) {
  SolvedSet set;
  for (const char* name : {"key", "fill"}) {
    set.capture.lights.push_back({name, Role::Other, {}});
    set.contributions.emplace_back(ImageSpec::rgb(width, height));
  }
  const LampPlace fill{1.2, .3, 1.5};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double px = (x + .5) / width - .5;
      const double py = (.5 * height - (y + .5)) / width;
      const unsigned tile = static_cast<unsigned>(x / 5 * 131 + y / 7 * 57) * 2654435761U;
      for (int c = 0; c < 3; ++c) {
        const double albedo = .2 + .6 * ((tile >> (8 * c + 3)) % 256) / 256.;
        set.contributions[0].span().at(c, x, y) = static_cast<float>(albedo * wallLight(key, px, py));
        set.contributions[1].span().at(c, x, y) = static_cast<float>(albedo * wallLight(fill, px, py));
      }
    }
  set.beta = Image(ImageSpec{width, height, {}, "data"});
  updateBeta(set);
  return set;
}

inline double meanError(const Image& a, const Image& b) {
  double sum = 0;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p) sum += std::abs(a.plane(c)[p] - b.plane(c)[p]);
  return sum / (3. * static_cast<double>(a.pixelCount()));
}

}  // namespace swaplight::test
