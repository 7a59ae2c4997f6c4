#include "core/bench/trade_off.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/bench/bench_truth.h"
#include "core/bench/hard_cases.h"
#include "core/bench/solution_error.h"
#include "core/bench/solver_error.h"
#include "core/bench/timed_solver.h"
#include "core/plot/plot.h"
#include "core/solve/model/estimator.h"
#include "core/solve/solve.h"

namespace swaplight {
namespace {

constexpr int kWidth = 960, kQuickWidth = 96;
constexpr double kSeconds = .4;

/// Two by two of each picture: more than caches hold.
CapturePixels fourTimes(const CapturePixels& pixels) {
  CapturePixels tiled = withoutShots(pixels);
  for (const Image& shot : pixels.shots) {
    ImageSpec spec = shot.spec();
    spec.width *= 2, spec.height *= 2;
    Image& image = tiled.shots.emplace_back(std::move(spec));
    for (int c = 0; c < shot.channelCount(); ++c)
      for (int y = 0; y < image.height(); ++y)
        for (int side = 0; side < 2; ++side)
          std::copy_n(shot.view().row(c, y % shot.height()), shot.width(),
                      image.span().row(c, y) + size_t(side) * size_t(shot.width()));
  }
  return tiled;
}

void measureScene(const HardCase& still, bool glossy, double seconds, std::vector<TradeOff>& rows) {
  const LightingMatrix lighting = lightingFromCapture(still.capture);
  const BoundedTruth truth(benchTruth(still.capture, still.truth), lighting, still.noise,
                           still.pixels.clipLevel.front());
  const int lights = lighting.lights;
  std::vector<TradeOff> these;
  for (const EstimatorInfo& info : estimators()) {
    if (info.model == Model::Single || !fitsCapture(info, lights, lighting.shots)) continue;
    SolveOptions options = still.options;
    options.solver = std::string(info.name);
    const SolutionError error = compareSolution(solve(still.capture, still.pixels, options), truth);
    these.push_back({options.solver, lights, glossy, 0, 0, error.deltaEMean, error.relativeRmse});
  }
  const BenchScene scene{still.capture, fourTimes(still.pixels)};
  SolvedSet room = roomFor(scene);
  for (TradeOff& row : these) {
    row.limit = memorySpeed(scene, room, true, seconds);  // beside it: what else runs slows both
    row.megapixels = row.solver == "brute-force" ? bruteForceSpeed(scene, room, seconds)
                                                 : estimatorSpeed(row.solver, scene, room, true, seconds);
    rows.push_back(std::move(row));
  }
}

/// A line an estimator, and the memory's limit as one along the bottom.
Image panel(const std::vector<TradeOff>& rows, bool glossy, const PlotAxis& x, const PlotAxis& y) {
  ScatterPlot plot;
  plot.title = glossy ? "Half of the surfaces glossy" : "Matte";
  plot.x = x, plot.y = y;
  std::map<std::string, size_t> places;
  ScatterPlot::Series limit{"memory's limit", {}, {}, ScatterPlot::Style::LineAndPoints};
  for (const TradeOff& row : rows) {
    if (row.glossy != glossy) continue;
    if (!places.contains(row.solver)) {
      places[row.solver] = plot.series.size();
      plot.series.push_back({row.solver, {}, {}, ScatterPlot::Style::LineAndPoints});
    }
    ScatterPlot::Series& series = plot.series[places[row.solver]];
    series.x.push_back(row.megapixels);
    series.y.push_back(row.deltaE);
    series.labels.push_back(std::to_string(row.lights));
    if (limit.labels.empty() || limit.labels.back() != series.labels.back()) {
      limit.x.push_back(row.limit);
      limit.y.push_back(*y.low);
      limit.labels.push_back(series.labels.back());
    }
  }
  plot.series.push_back(std::move(limit));
  return drawScatterPlot(plot, {900, 700});
}

}  // namespace

std::vector<TradeOff> measureTradeOff(unsigned seed, bool quick, const Progress& progress) {
  std::vector<TradeOff> rows;
  float done = 0;
  for (const bool glossy : {false, true})
    for (const int lights : {2, 3, 4, 8}) {
      progress.update(done++ / 8, fmt::format("{} lights, {}", lights, glossy ? "glossy" : "matte"));
      measureScene(makeStillLife(lights, glossy ? 1.0F : 0.0F, seed, quick ? kQuickWidth : kWidth), glossy,
                   quick ? 0 : kSeconds, rows);
    }
  return rows;
}

Image drawTradeOff(const std::vector<TradeOff>& rows) {
  double least = INFINITY, most = 0, slowest = INFINITY, fastest = 0;
  for (const TradeOff& row : rows) {
    least = std::min(least, row.deltaE), most = std::max(most, row.deltaE);
    slowest = std::min(slowest, row.megapixels), fastest = std::max({fastest, row.megapixels, row.limit});
  }
  const PlotAxis x{"megapixels a second (by the number of lights)", true, .8 * slowest, 1.4 * fastest};
  const PlotAxis y{"mean CIEDE2000 of a relit frame", true, .8 * least, 1.2 * most};
  const Image left = panel(rows, false, x, y), right = panel(rows, true, x, y);
  Image both(ImageSpec{left.width() + right.width(), left.height(), {"R", "G", "B"}, "srgb"});
  for (int c = 0; c < 3; ++c)
    for (int v = 0; v < both.height(); ++v) {
      std::copy_n(left.view().row(c, v), left.width(), both.span().row(c, v));
      std::copy_n(right.view().row(c, v), right.width(), both.span().row(c, v) + left.width());
    }
  return both;
}

}  // namespace swaplight
