#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/color/rgb.h"
#include "core/set/shot_shift.h"
#include "core/set/solved_set.h"

namespace swaplight {

struct LampReadingOptions {
  /// Of the photograph; nothing: the capture's, else estimated from the photograph.
  std::optional<SensorNoise> noise;
  float exposureStops = 0;       ///< the photograph's exposure over that of the capture's first shot
  std::optional<float> ambient;  ///< level of the light that no lamp explains; nothing: read as well
  bool align = false;            ///< register the photograph to the set (shift, turn, zoom)
};

/// What a lamp was doing.
struct ReadLamp {
  std::string light;
  Rgb color{0, 0, 0};  ///< linear, the set's primaries, level included: 1 1 1 is unit white
  Rgb error{0, 0, 0};  ///< standard error of each; infinite where the lamp lights nothing of the picture
  float luminance = 0, luminanceError = 0;
  /// Whether anything says that it was on: its luminance is more than three standard errors, and than a
  /// thousandth of the brightest lamp's.
  bool on = false;
};

/// What the lamps of a set were doing when a photograph of it was taken.
struct LampReading {
  std::vector<ReadLamp> lamps;     ///< in the set's order
  std::optional<float> ambient;    ///< its level over the set's; nothing: the set has none
  float ambientError = 0;          ///< 0 where it was given
  SensorNoise noise;               ///< that was used
  double misfit = 0;               ///< what a bright part of the picture differs from the set by, relative
  double expectedMisfit = 0;       ///< what noise alone would leave there
  double used = 0;                 ///< part of the picture that could be used: not clipped, known in the set
  double leftOut = 0;              ///< part of that which is something else: moved, or lit by other light
  std::optional<ShotShift> shift;  ///< where it was measured
  std::vector<std::string> warnings;
};

/// Reads every lamp's colour and level from one more photograph of a set that was solved: the inverse of
/// relighting. Linear regression of the photograph on the contributions: see fitLamps (lamp_fit.h). Instead
/// of a spectrophotometer (Lindsay 2013, 6.3), and to set the studio's lamps as they are.
///
/// `photograph`: of loadPhotographOf. At most 2^18 blocks of 2 x 2 pixels are looked at, evenly over the
/// picture. Throws InputError where nothing of the picture can be used.
[[nodiscard]] LampReading readLamps(const SolvedSet& set, const CapturePixels& photograph,
                                    const LampReadingOptions& options = {}, const Progress& progress = {});

}  // namespace swaplight
