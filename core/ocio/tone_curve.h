#pragma once

#include <span>

namespace swaplight {

// Tone curves for monitoring: scene-linear light, 1 = full scale of a shot, to display-linear light 0..1, a
// channel at a time in Rec.709 primaries. They are fixed curves: unlike in the papers nothing is taken from
// the picture (its mean, its brightest pixel), so that two frames and two lightings can be compared; exposure
// is the viewer's and the lights'. A channel at a time means that very bright colours go to white, as film's
// do. Below 0 each goes on along its tangent. Parameters out of range: std::invalid_argument.

/// x / (1 + x). Reinhard, Stark, Shirley and Ferwerda, "Photographic tone reproduction for digital images",
/// SIGGRAPH 2002, equation 3. No parameter; 0.18 becomes 0.153, infinity 1.
[[nodiscard]] double reinhardGlobal(double light);

/// x (1 + x / white^2) / (1 + x): equation 4 of the same paper. What is at `white` becomes 1, brighter light
/// stays there.
inline constexpr double kReinhardWhite =
    4;  ///< default; range 0.5..1e4. The paper: the brightest of the picture
[[nodiscard]] double reinhardExtended(double light, double white = kReinhardWhite);

/// f(2 x) / f(11.2) with f(x) = (x (A x + C B) + D E) / (x (A x + B) + D F) - E / F, A .15 shoulder, B .5 and
/// C .1 linear part, D .2, E .02 and F .3 toe. J. Hable, "Uncharted 2: HDR lighting", Game Developers
/// Conference 2010.
inline constexpr double kHableExposure = 2;  ///< default, Hable's own; range 0.01..100
inline constexpr double kHableWhite = 11.2;  ///< default, Hable's own; range 1..1e4
[[nodiscard]] double hable(double light, double exposure = kHableExposure, double white = kHableWhite);

/// log(1 + s x) / log(1 + s brightest) with s = 4: as equation 1 of Drago, Myszkowski, Annen and Chiba,
/// "Adaptive logarithmic mapping for displaying high contrast scenes", Eurographics 2003, with a fixed scale
/// s. What is at `brightest` becomes 1, brighter light stays there.
inline constexpr double kLogBrightest = 64;  ///< default: six stops above full scale; range 1..1e6
[[nodiscard]] double logarithmic(double light, double brightest = kLogBrightest);

/// AgX's curve: the stops about middle grey, -10 to +6.5, by a sigmoid with a straight middle and an even toe
/// and shoulder, the codes (display gamma 2.4) to display-linear light. 0.18 stays 0.18; what is 6.5 stops
/// brighter becomes 1, brighter light stays there, what is darker than ten stops below becomes 0. No
/// parameter: those of Blender's AgX (slope 2.4, toe and shoulder 1.5) after T. Sobotka; E. Chow,
/// AgX_LUT_Gen, sigmoid.py and AgXBasesRGB.py, 2023. For light in AgX's own primaries (builtin_config.cpp).
inline constexpr double kMiddleGrey = 0.18;
[[nodiscard]] double agxCurve(double light);
/// The view of the built-in configuration that holds it.
inline constexpr const char* kRolledOffView = "AgX";

/// One of the curves with its defaults, as the built-in colour configuration offers it as a view.
struct ToneCurve {
  const char* name;         ///< of the view
  const char* description;  ///< for people, one line
  double (*curve)(double light);
};
[[nodiscard]] std::span<const ToneCurve> toneCurves();

}  // namespace swaplight
