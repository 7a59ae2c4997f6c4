#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/base/json_fwd.h"
#include "core/capture/capture.h"

namespace swaplight {

/// How much of light transport a pixel's model allows for; each contains the one before.
enum class Model {
  Auto,       ///< what each pixel needs
  Single,     ///< one light reaches the pixel
  Lambert,    ///< proportions x reflectance: T[i][c] = beta[i] * rho[c]
  Gloss,      ///< proportions x reflectance + a white highlight a light
  Transport,  ///< a free contribution a light and channel, >= 0
};
[[nodiscard]] std::string modelName(Model model);
[[nodiscard]] Model modelFromName(const std::string& name);  ///< throws InputError, listing the known

/// What is done about the noise that telling the lights apart leaves.
enum class Denoise {
  Off,
  Guided,  ///< proportions pooled with like neighbours: see denoise.h
};
[[nodiscard]] std::string denoiseName(Denoise denoise);
[[nodiscard]] Denoise denoiseFromName(const std::string& name);  ///< throws InputError, listing the known

/// Whether something is taken off the photographs that nobody told of.
enum class Remedy {
  Off,
  Sure,  ///< where the photographs surely show it, and nothing else that it may be as well
  On,    ///< where it is likely
};

/// The least luminance of a gel that can be told: deeper ones leave nothing to see by.
inline constexpr double kLeastGelLuminance = 1e-3;

/// What settles an unknown colour of which the photographs leave one number open (SwappedColorLine). At most
/// one of the first four counts: in their order.
struct OpenColorChoice {
  struct OneLamp {
    std::string light;
    int x = 0, y = 0;
    bool operator==(const OneLamp&) const = default;
  };
  std::optional<OneLamp> oneLamp;          ///< a pixel of the pictures that only this light reaches
  std::optional<std::array<int, 2>> grey;  ///< x, y of a grey surface
  std::array<int, 2> corner{};             ///< of what is solved, in the picture that places are told of
  std::optional<float> luminance;  ///< of the unknown colour, bare lamps 1: the Y of a gel's data sheet
  std::optional<float> position;   ///< 0..1: from the colour nearest to the known one to the farthest
  bool exchanged = false;          ///< the lamps the other way round than is likelier
  bool operator==(const OpenColorChoice&) const = default;
};

/// What the person asks of a solve. What was made of it stands in SolveReport.
struct SolveOptions {
  Model model = Model::Auto;
  std::string solver;                ///< an estimator by name; empty: the model's own
  std::optional<SensorNoise> noise;  ///< instead of the capture's; neither: estimated from the shots
  /// Relative standard error of the light colours, 0..1: real gels are known to a few per cent. Negative:
  /// estimated from the shots.
  float colorUncertainty = -1;
  bool solveAmbient = false;  ///< one more unknown light, the same in every shot (K > N)
  bool refineColors = false;  ///< estimate the light colours from the pictures, starting at the manifest's
  Remedy correctTone = Remedy::Sure;  ///< take off a tone curve
  Remedy align = Remedy::Sure;        ///< register the shots to the first; On: whatever they show
  bool highlights = true;             ///< keep what of each light is highlight, where that is seen
  bool field = false;                 ///< find how the lamps' colours drift over the picture, and even them
  OpenColorChoice openColor;
  Denoise denoise = Denoise::Off;
  int guidedRadius = 8;  ///< pixels, 1..1000: how far Denoise::Guided looks

  /// Throws InputError that names the first value out of its range.
  void check() const;
  bool operator==(const SolveOptions&) const = default;
};

[[nodiscard]] Json jsonFromSolveOptions(const SolveOptions& options);
/// What is missing is at its default. `where` begins the messages. Throws InputError.
[[nodiscard]] SolveOptions solveOptionsFromJson(const Json& json, const std::string& where = "solve");

}  // namespace swaplight
