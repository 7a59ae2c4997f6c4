#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/measure/difference.h"
#include "core/measure/luminance_histogram.h"

namespace swaplight {

struct EvaluateOptions {
  std::vector<Metric> metrics = {Metric::DeltaE2000, Metric::AbsDiff, Metric::Rmse, Metric::Psnr};
  /// Exposure of the comparison, for linear pictures. Nothing: so that the reference's 99.5th percentile is
  /// .9. Pictures of sRGB code values are never scaled.
  std::optional<float> scale;
  std::filesystem::path plot;       ///< PNG of box plots to write, or empty
  std::filesystem::path map;        ///< PNG of the first metric in false colour to write, or empty
  std::filesystem::path histogram;  ///< PNG of both luminance histograms to write, or empty
  bool luminance = false;           ///< give the histograms, even where none is written
  float mapMaximum = 0;             ///< value at the top of the map's scale; 0: the 99th percentile
};

/// How a picture differs from its reference.
struct Evaluation {
  std::string test, reference;
  int width = 0, height = 0;
  bool encoded = false;  ///< compared as sRGB code values, else as linear light
  float scale = 1;
  std::vector<Difference> differences;  ///< one a metric, in the order asked for
  /// Of linear light, in stops from middle grey; where asked for.
  std::optional<LuminanceHistogram> testLuminance = {}, referenceLuminance = {};
};

/// Reads two pictures and compares R G B (one grey channel counts as all three). Floating-point files (EXR,
/// HDR) are taken as linear Rec.709, integer files (PNG, TIFF, JPEG) as sRGB; one of each is compared as
/// linear light. Throws InputError: unreadable file, pictures of different size, no R G B, no finite pixel,
/// bad scale, unwritable plot or map.
[[nodiscard]] Evaluation evaluate(const std::filesystem::path& test, const std::filesystem::path& reference,
                                  const EvaluateOptions& options = {});

/// One object; the statistics of each metric stand under its name.
[[nodiscard]] Json jsonFromEvaluation(const Evaluation& evaluation);
/// A table for people, several lines, ends with a newline.
[[nodiscard]] std::string textFromEvaluation(const Evaluation& evaluation);

}  // namespace swaplight
