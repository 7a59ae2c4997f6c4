#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// How the light on a set is told from what it falls on.
struct IlluminationOptions {
  /// Relief is evened out over this far: the standard deviation of a Gaussian, widths of the picture,
  /// 0..0.25; 0: surfaces show how they are turned to the light. Steps of more than half a stop, as a shadow
  /// or the edge of a cone makes them, stay.
  double smoothing = 0.03;
  bool operator==(const IlluminationOptions&) const = default;
};

/// The light on the set without what it falls on: for each light a picture of one channel, Y, as if
/// everything were of the set's own mean grey, lit by that light at unit white; linear, >= 0, finite, in the
/// set's size.
///
/// Texture is what all lights show alike, so that it is absent from a light's share of all light. What the
/// shares do not tell is the level of all light together. That is fitted around each pixel (local_fit.h) to
/// the logarithm of the set's sum, as what goes along with the shares; what goes along with the colour of the
/// surface, and what goes along with neither, is texture. So surfaces that differ for more than about a tenth
/// of the picture's width, and are of one hue, are partly taken for light. With a single light only colour
/// tells texture from light. Throws Stopped.
[[nodiscard]] std::vector<Image> illuminationMaps(const SolvedSet& set,
                                                  const IlluminationOptions& options = {},
                                                  const Progress& progress = {});

/// The set as if everything in it were of one grey: contributions are those pictures, R = G = B, beta
/// accordingly. Without ambient light: that is of no one lamp.
[[nodiscard]] SolvedSet greySet(const SolvedSet& set, const IlluminationOptions& options = {},
                                const Progress& progress = {});

}  // namespace swaplight
