#pragma once

#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/set/solved_set.h"
#include "core/solve/model/light_plan.h"
#include "core/solve/registration/align_shots.h"

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
  Conditioning conditioning;
  std::vector<ShotShift> shifts;  ///< of each shot against the first; empty: not measured
  double residualMedian = 0;      ///< in units of the expected noise
  double sigmaMedian = 0;         ///< relative to the sum of all lights
  size_t pixels = 0;
  size_t clipped = 0, tooDark = 0, moved = 0, notFinite = 0, filled = 0;  ///< counts of pixels
  double seconds = 0;
  std::vector<std::string> warnings;

  /// Fills in the statistics and the message from a set that is solved.
  void summarize(const SolvedSet& set);
};

/// What is infinite is null.
[[nodiscard]] Json jsonFromConditioning(const Conditioning& conditioning);
[[nodiscard]] Json jsonFromSolveReport(const SolveReport& report);

}  // namespace swaplight
