#pragma once

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
  bool align = false;         ///< register the shots to the first (sub-pixel translation)
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
