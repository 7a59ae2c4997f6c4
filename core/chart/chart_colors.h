#pragma once

#include <string>
#include <vector>

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

/// Reads charts beside the photographs of a set: files of the shots' folder, or else of anywhere; in the
/// shots' `colorSpace` (or a file of a response; "" is what the files say), over the exposure of the first
/// shot where both say theirs. Throws InputError as readChartShots does; Stopped.
[[nodiscard]] std::vector<ChartColor> chartColors(const ColorConfig& config, const ShotFolder& folder,
                                                  const std::string& colorSpace,
                                                  const std::vector<std::string>& names,
                                                  const Progress& progress = {});

}  // namespace swaplight
