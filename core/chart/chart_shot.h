#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/chart/chart_corners.h"
#include "core/chart/chart_fit.h"
#include "core/ocio/color_config.h"

namespace swaplight {

/// A photograph with a chart in it.
struct ChartShot {
  std::filesystem::path file;
  int width = 0, height = 0;  ///< of the photograph
  std::string colorSpace;     ///< linear: of its light and matrix
  ChartCorners corners{};
  bool found = true;           ///< by itself; else where it was told, or as in another photograph
  std::filesystem::path asIn;  ///< that one, where it is not found in this one; else empty
  ChartFit fit;
  /// log2 of exposure time x ISO / f-number squared; nothing where the file does not say all three.
  std::optional<double> exposureStops;
};

struct ChartReadingOptions {
  /// Of a file; none, or "": see colorSpaceOfPhotograph. May throw InputError.
  std::function<std::string(const std::filesystem::path&)> colorSpaceOf;
  std::optional<ChartCorners> corners;  ///< of the chart, in any order around it; nothing: it is looked for
  /// Takes what is wrong with a photograph, which is then left out. None: it is thrown.
  std::function<void(const InputError&)> leftOut;
};

/// The charts in photographs of one camera. Where a chart is not found in one of them (under a deep gel), it
/// is taken to be where it was found in another one of that size, the first of them, with a warning. Throws
/// InputError that names the file: cannot be read, no chart found, saturated; Stopped.
[[nodiscard]] std::vector<ChartShot> readChartShots(const ColorConfig& config,
                                                    const std::vector<std::filesystem::path>& files,
                                                    const ChartReadingOptions& options = {},
                                                    const Progress& progress = {});

/// The one whose matrix leaves the least of the patches; nothing where none has a matrix.
[[nodiscard]] const ChartShot* bestChartShot(const std::vector<ChartShot>& shots);

}  // namespace swaplight
