#pragma once

#include "core/color/chromaticity.h"

namespace swaplight {

// White light by its temperature. One choice of locus for the whole program: black body up to 4000 K, CIE
// daylight from 5000 K on, between them the mix of both spectra at equal luminance, linear in Kelvin (as IES
// TM-30-18 and CIE 224 choose their reference). 6504 K is D65.

inline constexpr double kLowestKelvin = 1000;
inline constexpr double kHighestKelvin = 25000;
inline constexpr double kD65Kelvin = 6504;

/// How far off the locus one full plus-green (L244) or minus-green (L247) gel moves a white, in Duv. They are
/// CC30 filters: a density of 0.3 outside (or inside) the green. Integrated over black bodies of 3200 and
/// 5600 K, such a filter with soft edges at 495 and 590 nm moves +0.038 and +0.035, the magenta one -0.042
/// and -0.040.
inline constexpr double kFullGreenDuv = 0.036;

/// The chromaticity of white at a temperature. Beyond 25000 K, where no daylight is defined, the locus runs
/// on beside the black body's (a blue gel over daylight comes there).
[[nodiscard]] Chromaticity whiteXy(double kelvin);

/// The CIE daylight locus (CIE 015:2018, 4.1.2), 4000..25000 K.
[[nodiscard]] Chromaticity daylightXy(double kelvin);

/// White at a temperature, moved across the locus by `duv` (positive: green) at the same temperature.
[[nodiscard]] Chromaticity whiteXy(double kelvin, double duv);

struct CorrelatedTemperature {
  double kelvin = 0;  ///< 1000..25000; at the ends where the colour lies beyond
  double duv = 0;     ///< distance from the black-body locus, positive above it (green)
};

/// The temperature of the black body that is nearest in CIE 1960 u, v, and the distance to it (the definition
/// of CIE 015 and of ANSI C78.377). Says little where |duv| > 0.05. Found by golden-section search on the
/// reciprocal temperature: exact to 0.01 mired.
[[nodiscard]] CorrelatedTemperature correlatedTemperature(const Chromaticity& xy);

}  // namespace swaplight
