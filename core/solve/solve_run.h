#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/set/solved_set.h"
#include "core/solve/calibration/chosen_color.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"
#include "core/solve/model/solve_options.h"
#include "core/solve/model/unknown_color.h"
#include "core/solve/solve_tuning.h"

namespace swaplight {

/// One solve, of photographs around full scale: its steps in their order, and what one hands to the next.
class SolveRun {
 public:
  /// All of them outlive the run. `movedBy`: as solve() has it. Throws InputError where the capture cannot be
  /// solved.
  SolveRun(const Capture& given, const CapturePixels& photographs, const SolveOptions& options,
           const SolveTuning& tuning, const Progress& progress, const std::vector<ShotShift>& movedBy);

  /// Once. Throws as solve() does.
  [[nodiscard]] SolvedSet run();

 private:
  void alignShots();         ///< m_report.shifts, and the shots moved by them
  void alignMovedShots();    ///< where they have surely moved, though nobody asked for it
  void placeUnknownColor();  ///< one that has changed places with a known one: before all that needs colours
  void calibrateNoise();     ///< from the capture, the options, or the shots
  void seekCauses();         ///< why the photographs do not fit the colours as told, where they do not
  void calibrateColors();    ///< of the ambient light and the lamps, and how far they are trusted
  void separateLights();     ///< contributions, beta and quality
  [[nodiscard]] std::vector<float> exposures() const;
  void completePixels();  ///< flags; fills what nothing is known of
  void finishReport();

  void fitLightColors();
  void setSwappedColor(const SwappedColor& swapped, const Rgb& color);
  void startFromLine(const SwappedColor& swapped, const SwappedColorLine& line);
  [[nodiscard]] float colorErrorEverywhere() const;
  [[nodiscard]] std::optional<float> shownColorError(float everywhere) const;
  void doubtFittedError();
  float judgeColors(float usual);
  [[nodiscard]] bool mayHaveMoved() const;
  [[nodiscard]] bool isAligned() const;  ///< some shot was moved
  [[nodiscard]] const CapturePixels& pixels() const { return m_aligned ? *m_aligned : m_photographs; }
  void warn(const std::vector<std::string>& warnings);

  std::chrono::steady_clock::time_point m_started = std::chrono::steady_clock::now();
  const Capture& m_given;
  const CapturePixels& m_photographs;
  const SolveOptions& m_options;
  const SolveTuning& m_tuning;
  const Progress& m_progress;
  const EstimatorInfo& m_info;
  Capture m_capture;  ///< with the ambient light as a light, where it is solved for
  std::vector<UnknownColor> m_unknownColors;
  EstimatorContext m_context;
  NoiseModel m_ownNoise;  ///< of the pixels alone
  SolveReport m_report;
  std::optional<CapturePixels> m_aligned;
  std::optional<ShotSignal> m_signal;
  Rgb m_ambientColor{1};
  SolvedSet m_set;
};

}  // namespace swaplight
