#pragma once

#include <array>
#include <compare>

namespace swaplight {

/// A grade of the finished frame: an ASC CDL (American Society of Cinematographers, Color Decision List 1.2),
///
///   out = (in * slope + offset) ^ power a channel, then saturation about Rec.709 luma,
///
/// without the clamp to 0..1 (OpenColorIO's CDL_NO_CLAMP: what is negative is not raised to a power). It
/// works on the logarithmic codes of the configuration's role color_timing, else ACEScct:
/// ColorConfig::gradingSpace.
struct ColorGrade {
  bool on = true;
  std::array<double, 3> slope{1, 1, 1};                 ///< R G B, 0 .. kMostGrade
  std::array<double, 3> offset{0, 0, 0};                ///< -kMostGrade .. kMostGrade
  std::array<double, 3> power{1, 1, 1};                 ///< 1 / kMostGrade .. kMostGrade
  double saturation = 1;                                ///< 0 .. kMostGrade
  auto operator<=>(const ColorGrade&) const = default;  // NOLINT(modernize-use-nullptr)

  /// Changes nothing, or is off.
  [[nodiscard]] bool idle() const;
};

/// Far beyond any use, and small enough that no light of half float becomes infinite on the way.
inline constexpr double kMostGrade = 16;

/// The same grade as colourists set it, a channel each:
///
///   out = (gain * (in + lift * (1 - in))) ^ (1 / gamma)
///
/// so that lift leaves white (code 1) alone and gain leaves black (code 0).
struct LiftGammaGain {
  std::array<double, 3> lift{0, 0, 0};
  std::array<double, 3> gamma{1, 1, 1};
  std::array<double, 3> gain{1, 1, 1};
  bool operator==(const LiftGammaGain&) const = default;
};
/// slope = gain (1 - lift), offset = gain lift, power = 1 / gamma; `grade`'s switch and saturation stay. What
/// a CDL cannot hold goes to the nearest that it can.
[[nodiscard]] ColorGrade withLiftGammaGain(ColorGrade grade, const LiftGammaGain& values);
/// A channel without gain (slope + offset = 0) is told as no lift.
[[nodiscard]] LiftGammaGain liftGammaGainOf(const ColorGrade& grade);

}  // namespace swaplight
