#include "core/solve/solve_photographs.h"

#include <algorithm>
#include <chrono>
#include <new>

#include "core/image/cropped_image.h"
#include "core/solve/causes/cause_context.h"
#include "core/solve/causes/cause_evidence.h"
#include "core/solve/causes/cause_sight.h"
#include "core/solve/causes/tone_correction.h"
#include "core/solve/even_lamps.h"
#include "core/solve/highlights/highlights.h"
#include "core/solve/model/crossed_shots.h"
#include "core/solve/registration/align_shots.h"
#include "core/solve/registration/moved_shots.h"
#include "core/solve/signal_scale.h"
#include "core/solve/solve_crossed.h"

namespace swaplight {

namespace {

constexpr float kSolving = 0.9F;  // of the work; the rest finds highlights
constexpr int kMostPasses = 2;    // more, for what a curve has left

double secondsSince(std::chrono::steady_clock::time_point started) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
}

bool isMoved(const SolvedSet& set) {
  const std::vector<ShotShift>& shifts = set.report->shifts;
  return std::any_of(shifts.begin(), shifts.end(), worthMoving);
}

/// Whether there may be highlights, and the model lets a light have another colour than the others.
bool showsHighlights(const SolvedSet& set) {
  const auto crossed = [](const Shot& shot) { return shot.crossed; };
  if (std::all_of(set.capture.shots.begin(), set.capture.shots.end(), crossed)) return false;
  const Model model = modelFromName(set.report->model);
  return model != Model::Single && model != Model::Lambert;
}

/// The curve of photographs that are moved onto one another as they lie. Highlights fit no matte model: where
/// some photographs are without, those say what it is.
std::optional<FoundTone> toneOf(const Capture& capture, CapturePixels& photographs,
                                const std::vector<ShotShift>& shifts, const SolveOptions& options,
                                const Progress& progress) {
  const auto found = [&](const Capture& of, const CapturePixels& pixels) {
    return findToneCorrection(of, pixels, options.noise, progress);
  };
  if (isPartlyCrossed(capture)) {
    BorrowedShots crossed(capture, true, photographs);
    return found(shotsOf(capture, true), crossed.pixels());
  }
  const bool moved = std::any_of(shifts.begin(), shifts.end(), worthMoving);
  return moved ? found(capture, movedShots(photographs, shifts)) : found(capture, photographs);
}

/// Of photographs that were solved as they were taken: what they are by then is not what was compared else.
std::vector<CauseSight> sightOf(const Capture& capture, const CapturePixels& photographs,
                                const std::optional<SensorNoise>& noise, const Progress& progress) {
  const float scale = signalScale(photographs, capture.calledName());
  if (scale == 1) return causeSight(capture, photographs, noise, progress);
  const std::optional<SensorNoise> told = toldNoise(capture, noise);
  return causeSight(capture, scaledSignal(photographs, scale),
                    told ? std::optional(scaledNoise(*told, scale)) : std::nullopt, progress);
}

/// Photographs that hold something everywhere.
SolvedSet solveAll(const Capture& capture, CapturePixels photographs, const FlatFields& fields,
                   const SolveOptions& options, const Progress& progress) {
  const auto solved = [&] {
    if (isPartlyCrossed(capture))
      return solveCrossed(capture, std::move(photographs), fields, options, progress);
    if (!options.highlights) return solveUneven(capture, photographs, fields, options, progress);
    SolvedSet set = solveUneven(capture, photographs, fields, options, progress.part(0, kSolving));
    const auto started = std::chrono::steady_clock::now();
    if (showsHighlights(set)) findHighlights(set, progress.part(kSolving, 1));
    set.report->seconds += secondsSince(started);
    return set;
  };
  std::optional<FoundTone> tone;
  const auto takeOff = [&](const std::vector<ShotShift>& shifts) {
    const std::optional<FoundTone> seen = toneOf(capture, photographs, shifts, options, progress);
    if (!seen || (!seen->steady && options.correctTone == Remedy::Sure)) return false;
    correctTone(seen->correction, photographs);
    tone =
        tone ? FoundTone{tone->correction.followedBy(seen->correction), tone->steady && seen->steady} : *seen;
    return true;
  };
  if (options.correctTone == Remedy::On) {
    progress.update(0, "Looking for a tone curve");
    takeOff(options.align == Remedy::On ? measureShifts(photographs, progress) : std::vector<ShotShift>{});
  }
  SolvedSet set = solved();
  // Where shots were taken through crossed polarisers, the photographs are gone.
  const bool more = !isPartlyCrossed(capture) && options.correctTone != Remedy::Off;
  for (int pass = 0; more && pass < kMostPasses; ++pass) {
    // What a camera that moved has left of a curve is seen where the photographs lie on one another.
    const bool wanted = tone || options.correctTone == Remedy::On;
    const bool left = wanted && isMoved(set) && set.report->causes.is(Cause::Tone);
    if (!left && (tone || !isSurelyTone(set.report->causes))) break;
    const double seconds = set.report->seconds;
    const std::vector<ShotShift> shifts = set.report->shifts;
    progress.update(0, "Looking for a tone curve");
    if (!takeOff(shifts)) break;
    set = {};  // two of them would be more than the memory is known to hold
    set = solved();
    set.report->seconds += seconds;
  }
  if (tone) {
    // What the solve said of a curve that is left, it said without knowing of this one.
    const bool aligned = !set.report->shifts.empty();
    auto& warnings = set.report->warnings;
    std::replace(warnings.begin(), warnings.end(), wordsFor(set.report->causes, {aligned, false}),
                 wordsFor(set.report->causes, {aligned, true}));
    reportTone(*tone, *set.report);
  } else if (options.correctTone == Remedy::On)
    set.report->message +=
        " The photographs do not surely show another tone curve than the declared one: none was taken off.";
  if (tone && options.correctTone == Remedy::Sure)
    set.report->warnings.emplace_back(
        "the photographs surely hold a tone curve that was not told: it was taken off "
        "(--tone declared leaves it)");
  MisfitCauses& causes = set.report->causes;
  const bool asTold = !options.solveAmbient && !options.refineColors && set.report->lampFields.empty();
  const bool asTaken = asTold && !tone && !isMoved(set) && !isPartlyCrossed(capture) && fields.empty();
  if (asTaken && !causes.all.empty() && causes.likely.empty() && !causes.unnamed) {
    const auto started = std::chrono::steady_clock::now();
    try {
      causes.sight = sightOf(capture, photographs, options.noise, progress);
    } catch (const std::bad_alloc&) {
      causes.sight.clear();  // what is solved is not lost by it
    }
    if (capture.ambient)
      std::erase_if(causes.sight, [](const CauseSight& one) { return one.cause == Cause::Ambient; });
    set.report->seconds += secondsSince(started);
  }
  return set;
}

/// The part of photographs that they hold.
CapturePixels croppedPixels(CapturePixels photographs, const PixelRect& window) {
  const auto crop = [&](Image& image) { image = croppedImage(image, window, "a photograph"); };
  std::for_each(photographs.shots.begin(), photographs.shots.end(), crop);
  if (photographs.ambient) crop(*photographs.ambient);
  return photographs;
}

/// A set of the window as one of the whole picture: outside there is no light, and nothing to doubt.
SolvedSet placedSet(SolvedSet set, const PixelRect& window, int width, int height) {
  const auto place = [&](Image& image) { image = placedImage(image, window, width, height); };
  std::for_each(set.contributions.begin(), set.contributions.end(), place);
  std::for_each(set.highlights.begin(), set.highlights.end(), place);
  if (set.ambient) place(*set.ambient);
  place(set.beta);
  place(set.quality);
  return set;
}

}  // namespace

SolvedSet solvePhotographs(const Capture& capture, CapturePixels photographs, const FlatFields& fields,
                           const SolveOptions& options, const Progress& progress) {
  const std::optional<PixelRect> window = photographs.dataWindow();
  if (!window) return solveAll(capture, std::move(photographs), fields, options, progress);
  const int width = photographs.width(), height = photographs.height();
  return placedSet(solveAll(capture, croppedPixels(std::move(photographs), *window),
                            fields.within(*window, width, height), options, progress),
                   *window, width, height);
}

}  // namespace swaplight
