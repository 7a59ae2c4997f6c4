#include "core/chart/chart_shot.h"

#include <algorithm>

#include "core/base/machine_error.h"
#include "core/chart/chart_photograph.h"

namespace swaplight {
namespace {

ChartPhotograph load(const ColorConfig& config, const std::filesystem::path& file,
                     const ChartReadingOptions& options, const Progress& progress) {
  return readChartPhotograph(config, file, options.colorSpaceOf ? options.colorSpaceOf(file) : "", progress);
}

/// What was read of a photograph: nothing where its chart is still to be looked for in another one's place.
struct Tried {
  std::filesystem::path file;
  std::optional<ChartShot> shot;
};

/// Looks for the chart, or at the corners told.
Tried tried(const ColorConfig& config, const std::filesystem::path& file, const ChartReadingOptions& options,
            const Progress& progress) {
  const ChartPhotograph photograph = load(config, file, options, progress.part(0, .4F));
  if (options.corners) return {file, chartAt(photograph, *options.corners)};
  return {file, foundChart(photograph, progress.part(.4F, 1))};
}

/// The chart of a photograph in which it is not found, where it is in the first other one of its size.
ChartShot readAt(const ColorConfig& config, const std::filesystem::path& file, const std::vector<Tried>& all,
                 const ChartReadingOptions& options, const Progress& progress) {
  const auto wasFound = [](const Tried& one) { return one.shot.has_value(); };
  if (std::any_of(all.begin(), all.end(), wasFound)) {
    const ChartPhotograph photograph = load(config, file, options, progress);
    const auto other = std::find_if(all.begin(), all.end(), [&](const Tried& one) {
      return one.shot && one.shot->width == photograph.picture().width() &&
             one.shot->height == photograph.picture().height();
    });
    if (other != all.end())
      if (const auto shot = chartAsIn(photograph, *other->shot)) return *shot;
  }
  throw InputError(
      "no chart found: all of a Macbeth chart of 24 patches must be seen, sharp, and its patches some 15 "
      "pixels wide; or tell its four corners (swaplight chart --corners X,Y,X,Y,X,Y,X,Y; in the studio, Read "
      "a colour chart)");
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
    naming(one.file, options, [&] {
      shots.push_back(one.shot ? *one.shot
                               : readAt(config, one.file, all, options, Progress{{}, progress.stop}));
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
