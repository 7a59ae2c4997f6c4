#include "core/chart/chart_colors.h"

#include <cmath>

#include "core/capture/response_curve.h"
#include "core/chart/chart_shot.h"

namespace swaplight {

std::vector<ChartColor> chartColors(const ColorConfig& config, const ShotFolder& folder,
                                    const std::string& colorSpace, const std::vector<std::string>& names,
                                    const Progress& progress) {
  if (names.empty()) return {};
  std::vector<std::filesystem::path> files;
  for (const std::string& name : names) {
    const bool inFolder = std::filesystem::exists(folder.folder / name);
    files.push_back(inFolder ? folder.folder / name : std::filesystem::path(name));
  }
  ChartReadingOptions options;
  options.colorSpace = isResponseFile(colorSpace) ? (folder.folder / colorSpace).string() : colorSpace;
  const std::vector<ChartShot> shots = readChartShots(config, files, options, progress);
  const auto& first = folder.shots.front().exposureStops;
  std::vector<ChartColor> colors;
  for (size_t k = 0; k < shots.size(); ++k) {
    const auto& own = shots[k].exposureStops;
    const auto over = float(first && own ? std::exp2(*first - *own) : 1);
    colors.push_back({names[k], shotColorFromRgb(shots[k].fit.light * over), shots[k].fit.warnings});
  }
  return colors;
}

}  // namespace swaplight
