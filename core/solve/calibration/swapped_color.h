#pragma once

#include "core/solve/calibration/calibration_tuning.h"
#include "core/solve/model/noise_model.h"
#include "core/solve/model/shot_signal.h"
#include "core/solve/model/solve_options.h"
#include "core/solve/model/unknown_color.h"

namespace swaplight {

/// The colours that a gel may have which has changed places with a known one l. On a matte surface that the
/// lamps light with beta and 1 - beta the photographs are y1 = rho (beta l + (1 - beta) m) and y2 = rho (beta
/// m + (1 - beta) l), so that in every channel
///   (y1 - y2) / (y1 + y2) = (2 beta - 1) d,  d = (l - m) / (l + m):
/// a matrix of rank one, whose factors the photographs say but for a common scale. It has bounds: no beta
/// lies outside 0..1, no channel of m is negative. Its sign is open, too: -d is the gel l^2 / m with the
/// lamps exchanged. docs/theory.md, Unknown colours.
struct SwappedColorLine {
  Rgb known{1};      ///< l; the geometric mean, where the lamps differ
  Rgb direction{0};  ///< d at position 0: as small as the pixels that are farthest from evenly lit allow (a
                     ///< lamp without a gel may lie nearer by what surfaces differ)
  float most = 1;    ///< times it at position 1, >= 1
  float likely = 0;  ///< the position to take where nothing else is told
  bool bareLamp = false;  ///< it is that of a lamp without a gel, which happens to lie on the line

  /// The unknown colour; position 0 .. 1.
  [[nodiscard]] Rgb at(float position) const;
  /// At every position what fits equally well with the lamps exchanged: known^2 / at(position).
  [[nodiscard]] SwappedColorLine opposite() const;
  /// How far from grey a surface would be that shows this light in both photographs, evened, together: its
  /// reflectance is (y1 + y2) / (l + m). The square of the logarithms' distance from their mean.
  [[nodiscard]] double tintOf(float position, const Rgb& light) const;
};

/// Finds the line: d by maximum likelihood in a robust fit of rank one (errors in both factors), its scale by
/// the pixels that are farthest from evenly lit (swap_shares.h). Of its two signs it takes the one on which a
/// lamp without a gel lies, then the one of a possible gel, then the one of a greyer set. `swapped`: of the
/// capture. Throws InputError where the two photographs do not differ: nothing was exchanged.
[[nodiscard]] SwappedColorLine swappedColorLine(const Capture& capture, const SwappedColor& swapped,
                                                const ShotSignal& signal, const NoiseModel& noise,
                                                const SwappedColorTuning& tuning = {});

}  // namespace swaplight
