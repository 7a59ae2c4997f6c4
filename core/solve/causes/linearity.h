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
#include "core/solve/causes/tone_evidence.h"

namespace swaplight {

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

/// Do these photographs hold light, as their colour space says? A tone curve is fitted to what additivity
/// leaves of the photographs, and to what the matte model leaves (tone_evidence.h). The noise is that of the
/// sensor, if it is told, else estimated. Full scale is about 1. Sums of brackets say something only where
/// their exposures are told or stated by the files: found in the pictures, they take a power of light along.
/// Unknown for more photographs or lights than a solve takes. Throws Stopped.
[[nodiscard]] LinearityEvidence linearityOf(const Capture& capture, const CapturePixels& photographs,
                                            const Progress& progress = {}, const CauseTuning& tuning = {});

/// "linear": true, false or null; the rest as above.
[[nodiscard]] Json jsonFromLinearity(const LinearityEvidence& evidence);

}  // namespace swaplight
