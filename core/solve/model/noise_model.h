#pragma once

#include "core/capture/capture_pixels.h"

namespace swaplight {

/// The variance of a shot's value y (linear, full scale 1) as a polynomial: constant + linear y + square y^2.
///  constant: read noise and rounding of linear codes; linear: photons (1 / full well); square: what is not
///  noise but is not known either, above all the colours of the lights (docs/theory.md, Light colours are not
///  known exactly). Rounding of other codes (sRGB, a log) is in all three.
struct NoiseModel {
  float constant = 0;
  float linear = 0;
  float square = 0;

  [[nodiscard]] float variance(float y) const {
    const float s = y > 0 ? y : 0;
    return constant + s * (linear + s * square);
  }
};

/// Photon and read noise of the shots, estimated from the pictures themselves: the second difference
/// (y00 - y10 - y01 + y11) / 2 of 2 x 2 pixels has the variance of the noise and ignores smooth shading; in
/// blocks of 8 x 8 pixels, in bins of signal, the quietest fifth of the blocks is taken for flat (its bias is
/// that of a chi-square quantile), and variance = read^2 + signal / fullWell is fitted through the bins.
/// Pixels at or beyond the clip level are left out. After Immerkaer 1996 and Foi et al. 2008.
[[nodiscard]] SensorNoise estimateSensorNoise(const CapturePixels& pixels);

/// The noise of a capture's shots once a constant ambient picture has been subtracted (the mean level stands
/// for all of it): `sensor`, with the quantisation and the JPEG coding of its files. `colorUncertainty` is
/// the relative standard error of a light's colour.
[[nodiscard]] NoiseModel noiseModel(const SensorNoise& sensor, const CapturePixels& pixels,
                                    float colorUncertainty);

}  // namespace swaplight
