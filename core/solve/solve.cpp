#include "core/solve/solve.h"

#include <chrono>

#include "core/base/json.h"
#include "core/solve/causes/shift_fit.h"
#include "core/solve/registration/align_shots.h"
#include "core/solve/registration/moved_shots.h"
#include "core/solve/signal_scale.h"
#include "core/solve/solve_run.h"

namespace swaplight {
namespace {

constexpr double kManyMoved = 0.005;  // of the pixels; .001 is the most of sets that stood still
constexpr float kFarApart = 0.5F;     // pixels, of photographs that were not registered

/// What a small shift explains is seen before the solve (Cause::Moved). Photographs that lie farther apart
/// than their edges are wide look like many things, and like something that moved in much of the picture.
bool mayLieFarApart(const SolveReport& report) {
  return report.shifts.empty() && double(report.moved) > kManyMoved * double(report.pixels);
}

/// Pictures far from full scale, as radiance in physical units may be: solved around 1, and scaled back.
SolvedSet solveScaled(const Capture& given, const CapturePixels& photographs, const SolveOptions& options,
                      float scale, const Progress& progress, const SolveTuning& tuning,
                      const std::vector<ShotShift>& movedBy) {
  Capture capture = given;
  SolveOptions scaled = options;
  for (auto* noise : {&capture.noise, &scaled.noise})
    if (*noise) *noise = scaledNoise(**noise, scale);
  SolvedSet set = solve(capture, scaledSignal(photographs, scale), scaled, progress, tuning, movedBy);
  unscale(set, scale);
  set.capture.noise = given.noise;
  set.report->options = jsonFromSolveOptions(options);
  set.report->noise = scaledNoise(set.report->noise, 1 / scale);
  return set;
}

}  // namespace

SolvedSet solve(const Capture& capture, const CapturePixels& photographs, const SolveOptions& options,
                const Progress& progress, const SolveTuning& tuning, const std::vector<ShotShift>& movedBy) {
  options.check();
  const std::string where = capture.calledName();
  if (const float scale = signalScale(photographs, where); scale != 1)
    return solveScaled(capture, photographs, options, scale, progress, tuning, movedBy);
  SolvedSet set = SolveRun(capture, photographs, options, tuning, progress, movedBy).run();
  if (options.align != Remedy::Sure || !mayLieFarApart(*set.report)) return set;
  const auto started = std::chrono::steady_clock::now();
  const double seconds = set.report->seconds;
  progress.update(0, "Aligning the photographs");
  std::vector<ShotShift> shifts = shiftsOfShots(capture, photographs, options.noise, progress);
  const float farthest = farthestMove(shifts, photographs.width(), photographs.height());
  const bool seenBefore = !set.report->causes.all.empty();
  if (seenBefore ? farthest < kFarApart : farthest == 0) {
    set.report->shifts = std::move(shifts);
    progress.update(1, "Solved");
    return set;
  }
  set = {};
  set = SolveRun(capture, movedShots(photographs, shifts), options, tuning, progress, shifts).run();
  set.report->seconds =
      seconds + std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return set;
}

}  // namespace swaplight
