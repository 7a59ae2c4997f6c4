#include "core/solve/causes/shift_fit.h"

#include <algorithm>
#include <cmath>

#include "core/solve/causes/cause_comparison.h"
#include "core/solve/causes/cause_context.h"
#include "core/solve/causes/cause_fit.h"
#include "core/solve/causes/cause_slopes.h"
#include "core/solve/registration/align_shots.h"
#include "core/solve/registration/moved_shots.h"
#include "core/solve/registration/shot_place.h"

namespace swaplight {
namespace {

constexpr int kMostRounds = 4;
constexpr float kSettled = 0.02F;  // pixels at a corner
constexpr float kNoTurn = 0.05F;   // pixels at a corner: shifting alone is exact and fast
constexpr float kMostChange = 2;   // pixels at a corner, that edges are wrong by at most

/// What the shots, moved so far, miss of each other: how much of it, and what would move them on.
struct Misfit {
  double squaredScale = 0;
  std::vector<ShotShift> step;
};

std::optional<Misfit> misfitOf(const Capture& capture, const CapturePixels& photographs,
                               const std::vector<ShotShift>& shifts, const std::optional<SensorNoise>& told,
                               const CauseTuning& tuning) {
  const CapturePixels moved = movedShots(photographs, shifts);
  const auto [context, signal] = causeContext(capture, moved, told);
  const std::vector<PixelMisfit> sample =
      misfitSample(context, signal, causeSampleSize(context, tuning), tuning);
  if (int(sample.size()) < tuning.fewestPixels) return std::nullopt;
  const MisfitRows rows = misfitRows(sample);
  const PixelSpan all{0, int(sample.size())};
  Misfit misfit;
  const Eigen::MatrixXd nothing(rows.residual.size(), 0);
  misfit.squaredScale = fitCause(rows, nothing, all, 1, tuning).squaredScale;
  for (const CauseModel& model : causeModels(context, signal, sample)) {
    if (model.cause != Cause::Moved) continue;
    const CauseFit fit = fitCause(rows, visibleSlopes(model, sample, rows), all, model.prior, tuning);
    for (const MovedUnknowns& one : movedUnknowns(model, fit.unknowns)) {
      ShotShift& step = misfit.step.emplace_back(ShotShift{float(one.right), float(one.down)});
      step.turn = float(one.turn);
      step.zoom = float(1 + one.zoom);
    }
  }
  return misfit;
}

/// First the step, in the places of the first shot, then what moved the shot there.
ShotShift together(const ShotShift& shift, const ShotShift& step) {
  const float cosine = shift.zoom * std::cos(shift.turn), sine = shift.zoom * std::sin(shift.turn);
  ShotShift both = shift;
  both.x += cosine * step.x - sine * step.y;
  both.y += sine * step.x + cosine * step.y;
  both.turn += step.turn;
  both.zoom *= step.zoom;
  both.spreadX = both.spreadY = 0;
  return both;
}

bool colorsAreKnown(const Capture& capture) {
  return std::all_of(capture.shots.begin(), capture.shots.end(), [](const Shot& shot) {
    return std::all_of(shot.lightColors.begin(), shot.lightColors.end(),
                       [](const auto& color) { return color.has_value(); });
  });
}

/// Better than edges have them.
std::vector<ShotShift> fitted(const Capture& capture, const CapturePixels& photographs,
                              const std::vector<ShotShift>& shifts, const std::optional<SensorNoise>& told,
                              const Progress& progress, const CauseTuning& tuning) {
  const int width = photographs.width(), height = photographs.height();
  std::vector<ShotShift> best = shifts, next = shifts;
  double least = INFINITY;
  for (int round = 0; round < kMostRounds; ++round) {
    progress.stopIfAsked();
    const std::optional<Misfit> misfit = misfitOf(capture, photographs, next, told, tuning);
    if (!misfit || misfit->squaredScale >= least) break;
    least = misfit->squaredScale;
    best = next;
    float change = 0, far = 0;
    for (size_t k = 1; k < next.size(); ++k) {
      if (!worthMoving(shifts[k])) continue;
      const ShotShift& step = misfit->step[k - 1];
      next[k] = together(next[k], step);
      change = std::max(change, ShotPlaces(step, width, height).farthestMove());
      far = std::max(far,
                     ShotPlaces(next[k], width, height).farthestFrom(ShotPlaces(shifts[k], width, height)));
    }
    if (change < kSettled || far > kMostChange) break;
  }
  for (ShotShift& shift : best)
    if (const ShotShift turn{0, 0, true, 0, 0, shift.turn, shift.zoom};
        ShotPlaces(turn, width, height).farthestMove() < kNoTurn)
      shift.turn = 0, shift.zoom = 1;
  return best;
}

}  // namespace

std::vector<ShotShift> shiftsOfShots(const Capture& capture, const CapturePixels& photographs,
                                     const std::optional<SensorNoise>& noise, const Progress& progress,
                                     const CauseTuning& tuning) {
  std::vector<ShotShift> shifts = measureShifts(photographs, progress);
  if (std::none_of(shifts.begin(), shifts.end(), worthMoving) || !colorsAreKnown(capture)) return shifts;
  if (causeSampleSize({lightingFromCapture(capture), {}}, tuning) == 0) return shifts;
  return fitted(capture, photographs, shifts, toldNoise(capture, noise), progress, tuning);
}

}  // namespace swaplight
