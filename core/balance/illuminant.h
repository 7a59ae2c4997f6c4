#pragma once

#include <limits>
#include <span>
#include <string>

#include "core/color/rgb.h"
#include "core/image/image.h"

namespace swaplight {

// White balance without knowing anything of the lamps: what cameras and photo editors do, and what a balance
// with a solved set is compared with.

/// An estimate of one light's colour, after van de Weijer, Gevers and Gijsenij 2007 ("Edge-based color
/// constancy"), equation 12: per channel (mean |d^n (G_s * y)|^p)^(1/p).
struct IlluminantStatistic {
  int derivative = 0;  ///< n: 0, 1 (gradient's magnitude) or 2 (sqrt(xx^2 + 4 xy^2 + yy^2))
  double norm = 1;     ///< p; infinity: the maximum
  double sigma = 0;    ///< s of the Gaussian, pixels
};

/// The light's colour by a statistic; linear, of any level. Clipped pixels (`clip` and above in a channel)
/// and those that are not finite are left out. White where nothing is left.
[[nodiscard]] Rgb estimateIlluminant(const Image& picture, float clip, const IlluminantStatistic& statistic);

/// A method by name.
struct BalanceMethod {
  const char* name;
  const char* description;  ///< for people, one line
};
/// grey-world, max-rgb, shades-of-grey, grey-edge, grey-edge-2, ebner, xphoto-simple, xphoto-grey-world,
/// xphoto-learning.
[[nodiscard]] std::span<const BalanceMethod> balanceMethods();

/// A picture balanced by a method, its luminance kept as well as the method can: by one colour everywhere, by
/// Ebner's local average ("Color Constancy", 2007: a Gaussian of .093 of the larger side, out = y Y(a) / a),
/// or by OpenCV's xphoto. `white` is of luminance 1 in the picture's primaries. Throws InputError that lists
/// the known methods.
[[nodiscard]] Image balanceByMethod(const Image& picture, float clip, const std::string& method,
                                    const Rgb& white, const Rgb& luminanceWeights);

/// The picture with its light's colour made white: out = y Y(light) / light w.
[[nodiscard]] Image balanceByColor(const Image& picture, const Rgb& light, const Rgb& white,
                                   const Rgb& luminanceWeights);

}  // namespace swaplight
