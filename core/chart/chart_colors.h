#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/intake/shot_color.h"
#include "core/intake/shot_folder.h"
#include "core/ocio/color_config.h"

namespace swaplight {

/// The light in a photograph of a chart, as a colour that a light of a capture had.
struct ChartColor {
  std::string file;  ///< as it was named
  ShotColor color;
  std::vector<std::string> warnings;
};

/// Reads charts beside the photographs of a set: files of the shots' folder, or else of anywhere. Those of
/// the shots' format are in their `colorSpace` (or a file of a response), others see colorSpaceOfPhotograph.
/// Where the charts say their exposures, over that of the first shot, or, where it says none, of the first
/// chart. Throws InputError as readChartShots does (`leftOut` as there), and where only some charts say
/// theirs; Stopped.
[[nodiscard]] std::vector<ChartColor> chartColors(const ColorConfig& config, const ShotFolder& folder,
                                                  const std::string& colorSpace,
                                                  const std::vector<std::string>& names,
                                                  const Progress& progress = {},
                                                  const std::function<void(const InputError&)>& leftOut = {});

}  // namespace swaplight
