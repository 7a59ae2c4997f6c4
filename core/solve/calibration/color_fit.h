#pragma once

#include <vector>

#include "core/solve/calibration/calibration_tuning.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"
#include "core/solve/model/unknown_color.h"

namespace swaplight {

/// What the photographs say of the colours that the lights are said to have had.
struct ColorFit {
  LightingMatrix lighting;  ///< with the refined colours
  double disagreement =
      0;             ///< RMS, relative to the signal: what the matte fit leaves in a typical bright pixel
  double noise = 0;  ///< what noise alone would leave there
  double systematic = 0;  ///< the part of it that the same wrong colours everywhere would explain
  /// Relative standard error of each unknown colour in its worst channel, the given ones being as uncertain
  /// as `priorSigma` says: near 1 where the photographs do not determine it.
  std::vector<double> unknownError;
  double change = 0;  ///< RMS of the refined colours against the given ones, relative
};

/// Fits small relative errors of every light's colour in every shot to the residuals of the matte model, over
/// a sample of the brighter pixels: Gauss-Newton with each pixel's own unknowns (beta, rho) projected out,
/// robust (weights 1 / (1 + chi-square)^2, so that gloss and moved things do not count), with a Gaussian
/// prior around the given colours. The prior also fixes the gauge: a factor a channel, a factor a light, and
/// any mixing of the lights that is the same in all channels cannot be seen in matte pixels, and stay as
/// given.
struct ColorFitOptions {
  int rounds = 1;
  double priorSigma = 0.03;           ///< relative standard error of a given colour
  std::vector<UnknownColor> unknown;  ///< each is one colour wherever it stands; their prior is flat
};
[[nodiscard]] ColorFit fitColors(const EstimatorContext& context, const ShotSignal& signal,
                                 const ColorFitOptions& options = {}, const ColorFitTuning& tuning = {});

/// The relative standard error of the light colours that explains the systematic disagreement; 0 where that
/// is no more than gloss and noise leave by chance.
[[nodiscard]] float colorUncertaintyOf(const ColorFit& fit, const ColorFitTuning& tuning = {});

/// How well the light colours of a capture are known that does not state its noise: a photograph (it has
/// noise) was lit with real gels; a rendering (it has none) with exact colours.
[[nodiscard]] float usualColorUncertainty(const SensorNoise& estimated, const ColorFitTuning& tuning = {});

}  // namespace swaplight
