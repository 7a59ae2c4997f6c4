#pragma once

#include <vector>

#include "core/normals/lamp_place.h"

namespace swaplight {

/// A lamp whose place was told, and its level: what the middle of the set would show of a surface of
/// reflectance 1 that faces it.
struct TunedLamp {
  LampPlace place;
  double level = 1;
};

/// What the lamps show of one pixel.
struct PixelSights {
  double x = 0, y = 0;        ///< widths of the picture from its middle, to the right and up
  std::vector<size_t> lamps;  ///< those that shine there: indices
  std::vector<double> light;  ///< of each of these
};

/// Turns the lamps and changes their levels so that four lamps and more agree on each pixel's normal.
///
/// Minimises the mean of rho((light_i / s_i - l_i . b) / |b|) over pixels and lamps, b the pixel's normal
/// times its reflectance under the same lamps, rho that of Geman and McClure at kOutlier, and the squares of
/// what was changed over the standard errors of what a person says: 12 degrees a lamp, `levelError` stops.
/// That three numbers a pixel explain all lamps leaves b -> A b open, l -> l inv(A) (Hayakawa, "Photometric
/// stereo under a light source with arbitrary motion", 1994); what was said closes it. Levenberg and
/// Marquardt. Nothing changes without four lamps that shine on a hundred of the pixels.
[[nodiscard]] std::vector<TunedLamp> refinedLamps(const std::vector<TunedLamp>& told,
                                                  const std::vector<PixelSights>& pixels, double levelError);

}  // namespace swaplight
