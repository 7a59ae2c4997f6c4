#include "core/chart/chart_shot.h"

#include <algorithm>

#include "core/balance/photograph.h"
#include "core/base/machine_error.h"
#include "core/capture/capture_pixels.h"
#include "core/chart/chart_finder.h"
#include "core/image/io/image_io.h"
#include "core/intake/shot_folder.h"

namespace swaplight {
namespace {

constexpr double kLeastAtPlace =
    .5;  // of a chart where it must be: under a gel that lets one channel through

/// What was read, where there is a chart.
struct Tried {
  ChartShot shot;
  int width = 0, height = 0;
  bool done = false;
};

CapturePixels load(const ColorConfig& config, const std::filesystem::path& file,
                   const ChartReadingOptions& options, const Progress& progress) {
  return loadPhotograph(config, file, options.colorSpaceOf ? options.colorSpaceOf(file) : "", progress);
}

ChartShot fitted(ChartShot shot, const CapturePixels& photograph) {
  shot.fit = fitChart(readChart(photograph.shots.front(), photograph.clipLevel.front(), shot.corners));
  return shot;
}

/// Looks for the chart, or at the corners told.
Tried tried(const ColorConfig& config, const std::filesystem::path& file, const ChartReadingOptions& options,
            const Progress& progress) {
  const CapturePixels photograph = load(config, file, options, progress.part(0, .4F));
  const Image& picture = photograph.shots.front();
  const float clip = photograph.clipLevel.front();
  Tried one{
      {file, picture.spec().colorSpace, {}, !options.corners, {}, {}, {}}, picture.width(), picture.height()};
  ImageFileInfo info;
  static_cast<void>(readImageSpec(file, &info));
  one.shot.exposureStops = statedExposure(info);
  const auto corners = options.corners ? orientedCorners(picture, clip, *options.corners)
                                       : findChart(picture, clip, progress.part(.4F, 1));
  if (!corners) return one;
  one.shot.corners = *corners;
  one.shot = fitted(std::move(one.shot), photograph);
  one.done = true;
  return one;
}

/// The chart of a photograph in which it is not found, where it is in another one.
ChartShot readAt(const ColorConfig& config, const Tried& missing, const std::vector<Tried>& all,
                 const ChartReadingOptions& options, const Progress& progress) {
  const auto other = std::find_if(all.begin(), all.end(), [&](const Tried& one) {
    return one.done && one.width == missing.width && one.height == missing.height;
  });
  const InputError none(
      "no chart found: all of a Macbeth chart of 24 patches must be seen, sharp, and its patches some 15 "
      "pixels wide; or tell its four corners (swaplight chart --corners X,Y,X,Y,X,Y,X,Y)");
  if (other == all.end()) throw none;
  const CapturePixels photograph = load(config, missing.shot.file, options, progress);
  ChartShot shot = missing.shot;
  shot.found = false;
  shot.corners = other->shot.corners;
  shot.asIn = other->shot.file;
  const ChartReading reading =
      readChart(photograph.shots.front(), photograph.clipLevel.front(), shot.corners);
  if (chartLikeness(reading) < kLeastAtPlace) throw none;
  shot = fitted(std::move(shot), photograph);
  shot.fit.warnings.push_back("no chart found: taken to be where it is in " + shot.asIn.filename().string());
  return shot;
}

/// Does the work of a file. What is wrong names it, and is thrown or left to `options`.
template <typename Work>
void naming(const std::filesystem::path& file, const ChartReadingOptions& options, const Work& work) {
  try {
    work();
  } catch (const MachineError&) {
    throw;
  } catch (const InputError& error) {
    const std::string what = error.what();
    const bool named = what.find(file.string()) != std::string::npos;
    const InputError wrong("{}", named ? what : file.string() + ": " + what);
    if (!options.leftOut) throw wrong;
    options.leftOut(wrong);
  }
}

}  // namespace

std::vector<ChartShot> readChartShots(const ColorConfig& config,
                                      const std::vector<std::filesystem::path>& files,
                                      const ChartReadingOptions& options, const Progress& progress) {
  std::vector<Tried> all;
  const auto each = 1 / float(files.size());
  for (size_t k = 0; k < files.size(); ++k) {
    const Progress part = progress.part(float(k) * each, float(k + 1) * each);
    naming(files[k], options, [&] { all.push_back(tried(config, files[k], options, part)); });
  }
  std::vector<ChartShot> shots;
  for (const Tried& one : all)
    naming(one.shot.file, options, [&] {
      shots.push_back(one.done ? one.shot : readAt(config, one, all, options, Progress{{}, progress.stop}));
    });
  return shots;
}

const ChartShot* bestChartShot(const std::vector<ChartShot>& shots) {
  const ChartShot* best = nullptr;
  for (const ChartShot& shot : shots)
    if (shot.fit.matrix && (best == nullptr || shot.fit.meanDeltaE < best->fit.meanDeltaE)) best = &shot;
  return best;
}

}  // namespace swaplight
