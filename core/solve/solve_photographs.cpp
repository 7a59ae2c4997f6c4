#include "core/solve/solve_photographs.h"

#include <algorithm>
#include <chrono>

#include "core/solve/causes/cause_evidence.h"
#include "core/solve/causes/tone_correction.h"
#include "core/solve/even_lamps.h"
#include "core/solve/highlights/highlights.h"
#include "core/solve/model/crossed_shots.h"
#include "core/solve/solve_crossed.h"

namespace swaplight {

namespace {

constexpr float kSolving = 0.9F;  // of the work; the rest finds highlights

/// Whether there may be highlights, and the model lets a light have another colour than the others.
bool showsHighlights(const SolvedSet& set) {
  const auto crossed = [](const Shot& shot) { return shot.crossed; };
  if (std::all_of(set.capture.shots.begin(), set.capture.shots.end(), crossed)) return false;
  const Model model = modelFromName(set.report->model);
  return model != Model::Single && model != Model::Lambert;
}

/// Highlights fit no matte model: where some photographs are without, those say what the curve is.
std::optional<ToneCorrection> toneOf(const Capture& capture, CapturePixels& photographs,
                                     const std::optional<SensorNoise>& noise) {
  if (!isPartlyCrossed(capture)) return findToneCorrection(capture, photographs, noise);
  BorrowedShots crossed(capture, true, photographs);
  return findToneCorrection(shotsOf(capture, true), crossed.pixels(), noise);
}

}  // namespace

SolvedSet solvePhotographs(const Capture& capture, CapturePixels photographs, const FlatFields& fields,
                           const SolveOptions& options, const Progress& progress) {
  const auto solved = [&] {
    if (isPartlyCrossed(capture))
      return solveCrossed(capture, std::move(photographs), fields, options, progress);
    if (!options.highlights) return solveUneven(capture, photographs, fields, options, progress);
    SolvedSet set = solveUneven(capture, photographs, fields, options, progress.part(0, kSolving));
    const auto started = std::chrono::steady_clock::now();
    if (showsHighlights(set)) findHighlights(set, progress.part(kSolving, 1));
    set.report->seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return set;
  };
  if (options.correctTone == Remedy::On) {
    const std::optional<ToneCorrection> tone = toneOf(capture, photographs, options.noise);
    if (tone) correctTone(*tone, photographs);
    SolvedSet set = solved();
    if (tone)
      reportTone(*tone, *set.report);
    else
      set.report->message +=
          " The photographs do not surely show another tone curve than the declared one: none was taken off.";
    return set;
  }
  SolvedSet set = solved();
  // Where shots were taken through crossed polarisers, the photographs are gone.
  if (options.correctTone == Remedy::Off || isPartlyCrossed(capture) || !isSurelyTone(set.report->causes))
    return set;
  const std::optional<ToneCorrection> tone = findToneCorrection(capture, photographs, options.noise);
  if (!tone) return set;
  correctTone(*tone, photographs);
  set = solved();
  reportTone(*tone, *set.report);
  set.report->warnings.emplace_back(
      "the photographs surely hold a tone curve that was not told: it was taken off (--tone declared leaves "
      "it)");
  return set;
}

}  // namespace swaplight
