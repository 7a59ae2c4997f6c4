#pragma once

#include <vector>

#include "core/color/chromaticity.h"

namespace swaplight {

/// The colour of a black body: Planck's law (c2 = 1.438776877e-2 m K) integrated against the colour matching
/// functions of the CIE 1931 observer, 380..780 nm in steps of 5 nm. Any temperature above 500 K.
/// Illuminant A (2856 K) comes out within 4e-5 of the published x, y.
[[nodiscard]] Chromaticity planckianXy(double kelvin);

/// The pure colours of the spectrum from violet (380 nm) to red (700 nm; beyond, the hue stays): with the
/// line from the last to the first, the border of all colours.
[[nodiscard]] std::vector<Chromaticity> spectralLocus();

}  // namespace swaplight
