#include "core/chart/chart_colors.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/balance/photograph.h"
#include "core/capture/response_curve.h"
#include "core/chart/measured_gel.h"
#include "core/image/io/image_io.h"
#include "core/ocio/convert_color.h"

namespace swaplight {
namespace {

/// What all charts' exposures are taken over: nothing where none says its.
std::optional<double> commonExposure(const ShotFolder& folder, const std::vector<ChartShot>& charts) {
  for (const ChartShot& chart : charts) static_cast<void>(exposureOver(chart, charts.front()));
  if (charts.empty() || !charts.front().exposureStops) return std::nullopt;
  const auto& shots = folder.shots.front().exposureStops;
  return shots ? shots : charts.front().exposureStops;
}

/// Of a chart whose light was exposed 1 / `over` times as much.
ShotColor lightOf(const ColorConfig& config, const ChartShot& chart, double over,
                  const std::string& colorSpace) {
  const Rgb light = convertColor(config, chart.fit.light, chart.colorSpace, linearSpaceOf(colorSpace));
  return shotColorFromRgb(glm::max(light * float(over), Rgb(0)));
}

}  // namespace

std::string colorSpaceOfChart(const ColorConfig& config, const ShotFolder& folder,
                              const std::string& colorSpace, const std::filesystem::path& file) {
  ImageFileInfo info;
  static_cast<void>(readImageSpec(file, &info));
  Capture shots;
  shots.folder = folder.folder;
  shots.colorSpace = colorSpace;
  if (info.format != folder.shots.front().format) return colorSpaceOfPhotograph(config, shots, file);
  return isResponseFile(colorSpace) ? (folder.folder / colorSpace).string() : colorSpace;
}

ShotColor lightOfChart(const ColorConfig& config, const ShotFolder& folder, const std::string& colorSpace,
                       const ChartShot& chart) {
  const auto& shots = folder.shots.front().exposureStops;
  const bool both = shots && chart.exposureStops;
  return lightOf(config, chart, both ? std::exp2(*shots - *chart.exposureStops) : 1, colorSpace);
}

std::vector<ChartColor> chartColors(const ColorConfig& config, const ShotFolder& folder,
                                    const std::string& colorSpace, const std::vector<std::string>& names,
                                    const Progress& progress,
                                    const std::function<void(const InputError&)>& leftOut) {
  if (names.empty()) return {};
  std::vector<std::filesystem::path> files;
  for (const std::string& name : names) {
    const bool inFolder = std::filesystem::exists(folder.folder / name);
    files.push_back(inFolder ? folder.folder / name : std::filesystem::path(name));
  }
  ChartReadingOptions options;
  options.colorSpaceOf = [&](const std::filesystem::path& file) {
    return colorSpaceOfChart(config, folder, colorSpace, file);
  };
  options.leftOut = leftOut;
  const std::vector<ChartShot> charts = readChartShots(config, files, options, progress);
  const std::optional<double> common = commonExposure(folder, charts);
  std::vector<ChartColor> colors;
  for (const ChartShot& chart : charts) {
    const double over = common ? std::exp2(*common - *chart.exposureStops) : 1;
    const auto k = std::find(files.begin(), files.end(), chart.file) - files.begin();
    colors.push_back({names[size_t(k)], lightOf(config, chart, over, colorSpace), chart.fit.warnings});
  }
  return colors;
}

}  // namespace swaplight
