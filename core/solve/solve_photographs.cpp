#include "core/solve/solve_photographs.h"

#include "core/solve/causes/tone_correction.h"
#include "core/solve/even_lamps.h"

namespace swaplight {

SolvedSet solvePhotographs(const Capture& capture, CapturePixels photographs, const FlatFields& fields,
                           const SolveOptions& options, const Progress& progress) {
  if (!options.correctTone) return solveUneven(capture, photographs, fields, options, progress);
  const std::optional<ToneCorrection> tone = findToneCorrection(capture, photographs, options.noise);
  if (tone) correctTone(*tone, photographs);
  SolvedSet set = solveUneven(capture, photographs, fields, options, progress);
  if (tone)
    reportTone(*tone, *set.report);
  else
    set.report->message +=
        " The photographs do not surely show another tone curve than the declared one: none was taken off.";
  return set;
}

}  // namespace swaplight
