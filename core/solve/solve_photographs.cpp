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

/// Photographs that hold something everywhere, and how they are solved: with a tone curve taken off where one
/// is seen, once more where a solve shows one.
class WholePhotographs {
 public:
  WholePhotographs(const Capture& capture, CapturePixels photographs, const FlatFields& fields,
                   const SolveOptions& options, const Progress& progress)
      : m_capture(capture),
        m_photographs(std::move(photographs)),
        m_fields(fields),
        m_options(options),
        m_progress(progress),
        m_partlyCrossed(isPartlyCrossed(capture)) {}

  /// Once: the photographs are used up.
  SolvedSet solved();

 private:
  SolvedSet solvedOnce();
  /// Whether one was seen.
  bool takeCurveOff(const std::vector<ShotShift>& shifts);
  [[nodiscard]] bool showsCurve(const SolveReport& report, bool moved) const;
  void reportCurve(SolveReport& report) const;
  /// What nothing would be said of.
  void reportSight(SolvedSet& set) const;

  const Capture& m_capture;
  CapturePixels m_photographs;
  const FlatFields& m_fields;
  const SolveOptions& m_options;
  const Progress& m_progress;
  bool m_partlyCrossed;
  std::optional<FoundTone> m_tone;  ///< what was taken off
};

SolvedSet WholePhotographs::solvedOnce() {
  if (m_partlyCrossed)
    return solveCrossed(m_capture, std::move(m_photographs), m_fields, m_options, m_progress);
  if (!m_options.highlights) return solveUneven(m_capture, m_photographs, m_fields, m_options, m_progress);
  SolvedSet set = solveUneven(m_capture, m_photographs, m_fields, m_options, m_progress.part(0, kSolving));
  const auto started = std::chrono::steady_clock::now();
  if (showsHighlights(set)) findHighlights(set, m_progress.part(kSolving, 1));
  set.report->seconds += secondsSince(started);
  return set;
}

bool WholePhotographs::takeCurveOff(const std::vector<ShotShift>& shifts) {
  m_progress.update(0, "Looking for a tone curve");
  const std::optional<FoundTone> seen = toneOf(m_capture, m_photographs, shifts, m_options, m_progress);
  if (!seen || (!seen->steady && m_options.correctTone == Remedy::Sure)) return false;
  correctTone(seen->correction, m_photographs);
  m_tone = m_tone ? FoundTone{m_tone->correction.followedBy(seen->correction), m_tone->steady && seen->steady}
                  : *seen;
  return true;
}

bool WholePhotographs::showsCurve(const SolveReport& report, bool moved) const {
  // What a camera that moved has left of a curve is seen where the photographs lie on one another.
  const bool wanted = m_tone || m_options.correctTone == Remedy::On;
  if (wanted && moved && report.causes.is(Cause::Tone)) return true;
  return !m_tone && isSurelyTone(report.causes);
}

void WholePhotographs::reportCurve(SolveReport& report) const {
  if (!m_tone) {
    if (m_options.correctTone == Remedy::On)
      report.message +=
          " The photographs do not surely show another tone curve than the declared one: none was taken off.";
    return;
  }
  // What the solve said of a curve that is left, it said without knowing of this one.
  const bool aligned = !report.shifts.empty();
  std::replace(report.warnings.begin(), report.warnings.end(), wordsFor(report.causes, {aligned, false}),
               wordsFor(report.causes, {aligned, true}));
  reportTone(*m_tone, report);
  if (m_options.correctTone == Remedy::Sure)
    report.warnings.emplace_back(
        "the photographs surely hold a tone curve that was not told: it was taken off "
        "(--tone declared leaves it)");
}

void WholePhotographs::reportSight(SolvedSet& set) const {
  MisfitCauses& causes = set.report->causes;
  const bool asTold = !m_options.solveAmbient && !m_options.refineColors && set.report->lampFields.empty();
  const bool asTaken = asTold && !m_tone && !isMoved(set) && !m_partlyCrossed && m_fields.empty();
  if (!asTaken || causes.all.empty() || !causes.likely.empty() || causes.unnamed) return;
  const auto started = std::chrono::steady_clock::now();
  try {
    causes.sight = sightOf(m_capture, m_photographs, m_options.noise, m_progress);
  } catch (const std::bad_alloc&) {
    causes.sight.clear();  // what is solved is not lost by it
  }
  if (m_capture.ambient)
    std::erase_if(causes.sight, [](const CauseSight& one) { return one.cause == Cause::Ambient; });
  set.report->seconds += secondsSince(started);
}

SolvedSet WholePhotographs::solved() {
  if (m_options.correctTone == Remedy::On) {
    const bool aligned = m_options.align == Remedy::On;
    takeCurveOff(aligned ? measureShifts(m_photographs, m_progress) : std::vector<ShotShift>{});
  }
  SolvedSet set = solvedOnce();
  // Where shots were taken through crossed polarisers, the photographs are gone.
  const bool more = !m_partlyCrossed && m_options.correctTone != Remedy::Off;
  for (int pass = 0; more && pass < kMostPasses && showsCurve(*set.report, isMoved(set)); ++pass) {
    const double seconds = set.report->seconds;
    if (!takeCurveOff(set.report->shifts)) break;
    set = {};  // two of them would be more than the memory is known to hold
    set = solvedOnce();
    set.report->seconds += seconds;
  }
  reportCurve(*set.report);
  reportSight(set);
  return set;
}

/// The part of photographs that they hold.
CapturePixels croppedPixels(CapturePixels photographs, const PixelRect& window) {
  const auto crop = [&](Image& image) { image = croppedImage(image, window, "a photograph"); };
  std::for_each(photographs.shots.begin(), photographs.shots.end(), crop);
  if (photographs.ambient) crop(*photographs.ambient);
  return photographs;
}

/// Places are told in the whole picture.
SolveOptions optionsWithin(SolveOptions options, const PixelRect& window) {
  if (options.openColor.oneLamp || options.openColor.grey) options.openColor.corner = {window.x, window.y};
  return options;
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
  if (!window) return WholePhotographs(capture, std::move(photographs), fields, options, progress).solved();
  const int width = photographs.width(), height = photographs.height();
  const FlatFields within = fields.within(*window, width, height);
  const SolveOptions there = optionsWithin(options, *window);
  WholePhotographs seen(capture, croppedPixels(std::move(photographs), *window), within, there, progress);
  return placedSet(seen.solved(), *window, width, height);
}

}  // namespace swaplight
