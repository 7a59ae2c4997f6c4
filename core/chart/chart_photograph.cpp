#include "core/chart/chart_photograph.h"

#include "core/balance/photograph.h"
#include "core/chart/chart_finder.h"
#include "core/image/io/image_io.h"
#include "core/intake/shot_folder.h"

namespace swaplight {
namespace {

constexpr double kLeastAtPlace =
    .5;  // of a chart where it must be: under a gel that lets one channel through

ChartShot shotOf(const ChartPhotograph& photograph, const ChartCorners& corners,
                 const ChartReading& reading) {
  ChartShot shot;
  shot.file = photograph.file;
  shot.width = photograph.picture().width();
  shot.height = photograph.picture().height();
  shot.colorSpace = photograph.picture().spec().colorSpace;
  shot.corners = corners;
  shot.fit = fitChart(reading);
  shot.exposureStops = photograph.exposureStops;
  return shot;
}

ChartShot shotOf(const ChartPhotograph& photograph, const ChartCorners& corners) {
  return shotOf(photograph, corners, readChart(photograph.picture(), photograph.clipLevel(), corners));
}

}  // namespace

ChartPhotograph readChartPhotograph(const ColorConfig& config, const std::filesystem::path& file,
                                    const std::string& colorSpace, const Progress& progress) {
  ChartPhotograph photograph{file, loadPhotograph(config, file, colorSpace, progress), {}};
  ImageFileInfo info;
  static_cast<void>(readImageSpec(file, &info));
  photograph.exposureStops = statedExposure(info);
  return photograph;
}

std::optional<ChartShot> foundChart(const ChartPhotograph& photograph, const Progress& progress) {
  const auto corners = findChart(photograph.picture(), photograph.clipLevel(), progress);
  if (!corners) return std::nullopt;
  return shotOf(photograph, *corners);
}

ChartShot chartAt(const ChartPhotograph& photograph, const ChartCorners& corners) {
  ChartShot shot = shotOf(photograph, orientedCorners(photograph.picture(), photograph.clipLevel(), corners));
  shot.found = false;
  return shot;
}

std::optional<ChartShot> chartAsIn(const ChartPhotograph& photograph, const ChartShot& other) {
  if (photograph.picture().width() != other.width || photograph.picture().height() != other.height)
    return std::nullopt;
  const ChartReading reading = readChart(photograph.picture(), photograph.clipLevel(), other.corners);
  if (chartLikeness(reading) < kLeastAtPlace) return std::nullopt;
  ChartShot shot = shotOf(photograph, other.corners, reading);
  shot.found = false;
  shot.asIn = other.file;
  shot.fit.warnings.push_back("no chart found: taken to be where it is in " + other.file.filename().string());
  return shot;
}

}  // namespace swaplight
