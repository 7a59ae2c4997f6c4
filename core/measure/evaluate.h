#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/image/pixel_rect.h"
#include "core/measure/difference.h"
#include "core/measure/luminance_histogram.h"

namespace swaplight {

/// A part of the pictures that is measured by itself, too.
struct EvaluatedRegion {
  std::string name;
  PixelRect pixels;
};

/// "face=120,40,60,80" or "120,40,60,80", which is then its name as well. Throws InputError.
[[nodiscard]] EvaluatedRegion regionFromText(const std::string& text);

struct EvaluateOptions {
  std::vector<Metric> metrics;        ///< empty: all that apply
  DifferenceOptions difference;       ///< weights and threshold
  std::vector<std::string> channels;  ///< compared as numbers; see readCompared
  std::vector<EvaluatedRegion> regions;
  std::optional<float> scale;       ///< exposure of linear pictures; see readCompared
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
  bool encoded = false;               ///< compared as sRGB code values, else as linear light
  std::vector<std::string> channels;  ///< compared as numbers; empty: R G B
  float scale = 1;
  std::vector<Difference> differences;  ///< one a metric, in the order asked for; over all channels
  /// The same of one channel, where several are compared as numbers, or of one region.
  struct Part {
    std::string name;
    std::optional<PixelRect> pixels;      ///< of a region
    std::vector<Difference> differences;  ///< without their maps
  };
  std::vector<Part> parts;  ///< channels, then regions
  /// Of linear light, in stops from middle grey; where asked for.
  std::optional<LuminanceHistogram> testLuminance = {}, referenceLuminance = {};
  std::vector<std::string> warnings = {};
};

/// Reads two pictures (see readCompared) and compares them. Throws InputError as that does, and: no finite
/// pixel, a region that does not lie inside, de2000 asked for of numbers, unwritable plot or map.
[[nodiscard]] Evaluation evaluate(const std::filesystem::path& test, const std::filesystem::path& reference,
                                  const EvaluateOptions& options = {});

/// One object; the statistics of each metric stand under its name, those of channels and regions in
/// `channels` and `regions` by theirs.
[[nodiscard]] Json jsonFromEvaluation(const Evaluation& evaluation);
/// A table for people, several lines, ends with a newline.
[[nodiscard]] std::string textFromEvaluation(const Evaluation& evaluation);

}  // namespace swaplight
