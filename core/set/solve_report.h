#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/base/kept_json.h"
#include "core/capture/capture.h"
#include "core/color/rgb.h"
#include "core/set/conditioning.h"
#include "core/set/lamp_field.h"
#include "core/set/misfit_cause.h"
#include "core/set/open_color.h"
#include "core/set/shot_shift.h"
#include "core/set/taken_tone.h"

namespace swaplight {

/// What a solve did, and how far to trust it.
struct SolveReport {
  std::string message;  ///< a paragraph for a person
  std::string model;
  std::string solver;
  SensorNoise noise;
  bool noiseGiven = false;
  float colorUncertainty = 0;      ///< relative, of a light's colour: given or estimated
  double colorDisagreement = 0;    ///< what the matte model leaves in bright pixels, relative to the signal
  double colorChange = 0;          ///< RMS change of the colours that were refined, relative
  std::vector<Rgb> refinedColors;  ///< [shot * lights + light], exposure included; empty: as given
  std::vector<std::string> estimated;  ///< colours that were not given, and what they were found to be
  std::optional<OpenColor> openColor;  ///< a colour that the photographs do not determine
  Conditioning conditioning;
  std::vector<ShotShift>
      shifts;                 ///< of each shot against the first; empty: not measured. A file keeps no spread
  double residualMedian = 0;  ///< in units of the expected noise
  double sigmaMedian = 0;     ///< relative to the sum of all lights
  size_t pixels = 0;
  double highlights = 0;  ///< part of the picture in which some were found, 0..1
  size_t clipped = 0, tooDark = 0, moved = 0, notFinite = 0, filled = 0;  ///< counts of pixels
  size_t lost = 0;  ///< of the pixels not finite (or negative): those whose other values are too few
  double seconds = 0;
  MisfitCauses causes;                ///< why the photographs do not fit the colours as told
  std::optional<TakenTone> tone;      ///< taken off before the solve
  std::vector<LampField> lampFields;  ///< found in the photographs and evened; empty: none
  std::vector<std::string> warnings;
  KeptJson options;  ///< what was asked for, as SolveOptions are written: for a person who looks later
  KeptJson unknown;  ///< what another version of the program has reported
};

/// What is infinite is null.
[[nodiscard]] Json jsonFromConditioning(const Conditioning& conditioning);
[[nodiscard]] Json jsonFromSolveReport(const SolveReport& report);
/// What travels with a picture that was made of the set: the figures without the details.
[[nodiscard]] Json jsonFromSolveSummary(const SolveReport& report);
/// What is missing is at its default. `where` begins the messages. Throws InputError.
[[nodiscard]] SolveReport solveReportFromJson(const Json& json, const std::string& where);

}  // namespace swaplight
