#include "core/solve/solve_photographs.h"

#include <chrono>

#include "core/solve/causes/tone_correction.h"
#include "core/solve/even_lamps.h"
#include "core/solve/highlights.h"

namespace swaplight {

namespace {

constexpr float kSolving = 0.9F;  // of the work; the rest finds highlights

/// Whether the model lets a light have another colour than the others.
bool showsHighlights(const SolvedSet& set) {
  const Model model = modelFromName(set.report->model);
  return model != Model::Single && model != Model::Lambert;
}

}  // namespace

SolvedSet solvePhotographs(const Capture& capture, CapturePixels photographs, const FlatFields& fields,
                           const SolveOptions& options, const Progress& progress) {
  const auto solved = [&] {
    if (!options.highlights) return solveUneven(capture, photographs, fields, options, progress);
    SolvedSet set = solveUneven(capture, photographs, fields, options, progress.part(0, kSolving));
    const auto started = std::chrono::steady_clock::now();
    if (showsHighlights(set)) findHighlights(set, progress.part(kSolving, 1));
    set.report->seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return set;
  };
  if (!options.correctTone) return solved();
  const std::optional<ToneCorrection> tone = findToneCorrection(capture, photographs, options.noise);
  if (tone) correctTone(*tone, photographs);
  SolvedSet set = solved();
  if (tone)
    reportTone(*tone, *set.report);
  else
    set.report->message +=
        " The photographs do not surely show another tone curve than the declared one: none was taken off.";
  return set;
}

}  // namespace swaplight
