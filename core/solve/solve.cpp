#include "core/solve/solve.h"

#include "core/base/json.h"
#include "core/solve/signal_scale.h"
#include "core/solve/solve_run.h"

namespace swaplight {
namespace {

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
  return SolveRun(capture, photographs, options, tuning, progress, movedBy).run();
}

}  // namespace swaplight
