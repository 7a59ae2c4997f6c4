#include "core/solve/solve_photographs.h"

#include "core/solve/causes/tone_correction.h"
#include "core/solve/even_lamps.h"
#include "core/solve/highlights.h"

namespace swaplight {

namespace {

/// Whether the model lets a light have another colour than the others.
bool showsHighlights(const SolvedSet& set) {
  const Model model = modelFromName(set.report->model);
  return model != Model::Single && model != Model::Lambert;
}

}  // namespace

SolvedSet solvePhotographs(const Capture& capture, CapturePixels photographs, const FlatFields& fields,
                           const SolveOptions& options, const Progress& progress) {
  const auto solved = [&] {
    SolvedSet set = solveUneven(capture, photographs, fields, options, progress);
    if (options.highlights && showsHighlights(set)) findHighlights(set);
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
