#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/chart/chart_shot.h"
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

/// The colour space of a chart's photograph beside the shots of a set: a file of the shots' format is in
/// their `colorSpace` (or a file of a response), another one in what it says, or, with codes, in what they
/// are coded in. Throws InputError that names the file where it cannot be read.
[[nodiscard]] std::string colorSpaceOfChart(const ColorConfig& config, const ShotFolder& folder,
                                            const std::string& colorSpace, const std::filesystem::path& file);

/// The light of a chart that was read by itself, in the primaries of the shots' `colorSpace`; over the
/// exposure of the first shot where both say theirs, else as if they were exposed alike.
[[nodiscard]] ShotColor lightOfChart(const ColorConfig& config, const ShotFolder& folder,
                                     const std::string& colorSpace, const ChartShot& chart);

/// Reads charts beside the photographs of a set: files of the shots' folder, or else of anywhere. Of
/// their colour spaces see colorSpaceOfChart. Where the charts say their exposures, over that of the first
/// shot, or, where it says none, of the first chart. Throws InputError as readChartShots does (`leftOut` as
/// there), and where only some charts say theirs; Stopped.
[[nodiscard]] std::vector<ChartColor> chartColors(const ColorConfig& config, const ShotFolder& folder,
                                                  const std::string& colorSpace,
                                                  const std::vector<std::string>& names,
                                                  const Progress& progress = {},
                                                  const std::function<void(const InputError&)>& leftOut = {});

}  // namespace swaplight
