#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/set/misfit_cause.h"
#include "core/solve/causes/cause_tuning.h"

namespace swaplight {

/// A tone curve as one way of looking at photographs sees it: what they hold, over the light that their
/// colour space says. 1 everywhere and sure: they hold light.
struct ToneEvidence {
  double levelError = 0;     ///< what photographs whose levels are off by 2 % add to the exponent
  double exponent = 1;       ///< the power of light that fits best
  double exponentError = 0;  ///< its standard error, over parts of the picture
  double departure = 0;      ///< largest logarithm of values over light by the best curve of three terms, but
                             ///< for exposure
  double departureError = 0;  ///< its standard error, over parts of the picture
  double explained = 0;       ///< of the misfit's variance, by that curve
  double misfit = 0;          ///< without a curve, RMS, over the sensor's noise and CauseTuning::modelError
};

/// Whether a capture's photographs hold light, and how that is known.
struct LinearityEvidence {
  enum class Answer { Linear, Curved, Unknown };
  Answer answer = Answer::Unknown;
  /// By adding photographs up, where their lamps depend on each other: true whatever surfaces do.
  std::optional<ToneEvidence> additivity;
  bool ambientProof = false;  ///< that knows of ambient light
  /// By the matte model under the colours as told; none where a colour is unknown.
  std::optional<ToneEvidence> matte;
  MisfitCauses causes;  ///< what else the matte model's misfit looks like
  /// {value of the files as declared, light}, linear, full scale 1, of the evidence that the answer is by.
  std::vector<std::array<float, 2>> curve;
  std::string finding;  ///< the answer, for a person
  std::string words;    ///< the same, and what to do on the command line
};

/// Do these photographs hold light, as their colour space says? A tone curve of three terms (cause_slopes.h:
/// an exponent, and contrast) is fitted to what additivity leaves of the photographs, and to what the matte
/// model leaves; its standard error is that over sixteen parts of the picture, left out in turns (Efron's
/// jackknife), and what the sample cannot show at all. The noise is that of the sensor, if it is told, else
/// estimated. Full scale is about 1. Sums of brackets say something only where their exposures are told or
/// stated by the files: found in the pictures, they take a power of light along. Unknown for more
/// photographs or lights than a solve takes. Throws Stopped.
[[nodiscard]] LinearityEvidence linearityOf(const Capture& capture, const CapturePixels& photographs,
                                            const Progress& progress = {}, const CauseTuning& tuning = {});

/// "linear": true, false or null; the rest as above.
[[nodiscard]] Json jsonFromLinearity(const LinearityEvidence& evidence);

}  // namespace swaplight
