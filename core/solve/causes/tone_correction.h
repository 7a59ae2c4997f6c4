#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/set/solve_report.h"
#include "core/solve/causes/cause_tuning.h"

namespace swaplight {

/// What takes off a tone curve that nobody told: a value of the files (decoded as declared) for each light.
class ToneCorrection {
 public:
  /// Nothing is changed.
  ToneCorrection();
  /// The light of a value (linear, full scale 1; more goes on in proportion, 0 and less stays).
  [[nodiscard]] float operator()(float value) const;
  /// Takes e^gain(light) off as well, `gain` at the lights of `values`; as much of it as keeps the curve
  /// rising. Returns the largest change of the logarithm that was made.
  double takeOff(const std::vector<double>& gain);
  /// Both, this one first.
  [[nodiscard]] ToneCorrection followedBy(const ToneCorrection& next) const;
  /// The geometric mean of the lights of both.
  [[nodiscard]] ToneCorrection halfWayTo(const ToneCorrection& other) const;
  /// The lights, as they are now, of the values that the correction is kept at.
  [[nodiscard]] std::vector<double> lights() const;
  /// What the camera did: the power of light, over the middle of the range, that the files hold.
  [[nodiscard]] double exponent() const;
  /// {value, light} at a few values, dark to bright: what a report shows.
  [[nodiscard]] std::vector<std::array<float, 2>> curve() const;

  /// It is found in so many rounds at most, fewer where one changes the logarithm of light by less.
  static constexpr int kMostRounds = 8;
  static constexpr double kSettled = 1e-3;

 private:
  static constexpr int kLevels = 241;  ///< of value, evenly in the logarithm
  std::array<double, kLevels> m_logLight;
};

/// A curve, and whether it is the same whether bounced light is allowed for or not
/// (CauseTuning::steadyExponent): else something else may have been taken for it.
struct FoundTone {
  ToneCorrection correction;
  bool steady = true;
};

/// Finds the tone curve by Gauss-Newton: the Tone cause of misfitCauses() is fitted, taken off, and fitted
/// again. With it goes a little of the Ambient cause, as much as bounced light looks like
/// (CauseTuning::bounced): without it, the curve would explain that, too. Where both curves are nearly the
/// same it is the one between them, else (FoundTone::steady) the one with it. Nothing where Tone is not the
/// likeliest cause, or ambient light may be it. Throws InputError where a light colour is unknown: the curve
/// and the colour could not be told apart; Stopped. `noise`: the sensor's, if it is told otherwise than by
/// the capture.
[[nodiscard]] std::optional<FoundTone> findToneCorrection(const Capture& capture,
                                                          const CapturePixels& photographs,
                                                          const std::optional<SensorNoise>& noise = {},
                                                          const Progress& progress = {},
                                                          const CauseTuning& tuning = {});

/// The photographs, and the ambient one, with the curve taken off.
void correctTone(const ToneCorrection& tone, CapturePixels& photographs);

/// Says so in the report: SolveReport::tone and the message; a warning where it is not steady.
void reportTone(const FoundTone& tone, SolveReport& report);

}  // namespace swaplight
