#include "core/solve/solve_crossed.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/solve/crossed_shots.h"
#include "core/solve/even_lamps.h"
#include "core/solve/highlights/crossed_pass.h"
#include "core/solve/highlights/highlight_light.h"
#include "core/solve/model/unknown_color.h"
#include "core/solve/registration/align_shots.h"

namespace swaplight {
namespace {

constexpr float kFound = 0.35F, kTaken = 0.45F;  // of the work: the matte set is known, the highlights are
constexpr double kWorthwhile = 1e-4;             // part of the picture that has to show highlights

std::string messagePlace(const Capture& capture) {
  return capture.file.empty() ? capture.name : capture.file.filename().string();
}

void check(const Capture& capture, const FlatFields& fields) {
  if (!unknownColorsOf(capture).empty())
    throw InputError(
        "{}: a light's colour is unknown, and some photographs are crossed: what the polarisers take and the "
        "colour cannot be told apart. Measure the colour, or leave the crossed photographs out.",
        messagePlace(capture));
  if (!fields.lamps.empty())
    throw InputError(
        "{}: has flat fields of its lamps and crossed photographs: both are not solved together. Leave one "
        "of "
        "them out.",
        messagePlace(capture));
}

/// The crossed shots as if nothing were crossed: darker lamps on a matte set.
Capture withoutFilters(Capture capture, const Rgb& pass) {
  const float mean = (pass.r + pass.g + pass.b) / 3;
  for (Shot& shot : capture.shots) {
    if (!shot.crossed) continue;
    shot.crossed = false;
    shot.exposureStops += std::log2(mean);
    for (std::optional<Rgb>& color : shot.lightColors) *color *= pass / mean;
  }
  return capture;
}

/// The set that the crossed shots show.
SolvedSet solveMatte(const Capture& capture, const CapturePixels& photographs, const SolveOptions& options,
                     const Progress& progress) {
  try {
    return solve(capture, photographs, options, progress);
  } catch (const InputError& error) {
    throw InputError("{}: its crossed photographs must tell the lights apart by themselves: {}",
                     messagePlace(capture), error.what());
  }
}

std::string wordsFor(const CrossedPass& pass, double part) {
  const std::string found =
      part < kWorthwhile ? "No highlights" : fmt::format("Highlights in {:.2f} % of the picture", 100 * part);
  return fmt::format(" {}, by crossed polarisers, which pass {:.0f} % of the other light.", found,
                     100 * (pass.part.r + pass.part.g + pass.part.b) / 3);
}

void addHighlights(HighlightLight found, bool keep, SolvedSet& set) {
  for (size_t i = 0; i < found.lights.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      float* light = set.contributions[i].plane(c);
      const float* highlight = found.lights[i].plane(c);
      for (size_t p = 0; p < set.beta.pixelCount(); ++p) light[p] += highlight[p];
    }
  updateBeta(set);
  if (!keep || found.part < kWorthwhile) return;
  set.highlights = std::move(found.lights);
  set.report->highlights = found.part;
}

}  // namespace

SolvedSet solveCrossed(const Capture& capture, CapturePixels photographs, const FlatFields& fields,
                       const SolveOptions& options, const Progress& progress) {
  const auto started = std::chrono::steady_clock::now();
  check(capture, fields);
  SolveOptions plain = options;
  std::vector<ShotShift> shifts;
  if (std::exchange(plain.align, false)) {
    progress.update(0, "Aligning the photographs");
    shifts = measureShifts(photographs);
    if (std::any_of(shifts.begin(), shifts.end(), worthMoving)) photographs = movedShots(photographs, shifts);
  }
  const CrossedPass pass = crossedPass(capture, photographs);
  const Capture matte = withoutFilters(capture, pass.part);
  HighlightLight found;
  {
    const SolvedSet without = [&] {
      BorrowedShots crossed(capture, true, photographs);
      SolveOptions even = plain;
      even.field = false;
      return solveMatte(withoutFilters(shotsOf(capture, true), pass.part), crossed.pixels(), even,
                        progress.part(0, kFound));
    }();
    const Capture seen = shotsOf(capture, false);
    BorrowedShots open(capture, false, photographs);
    found = highlightLight(seen, open.pixels(), without, progress.part(kFound, kTaken));
    takeHighlights(seen, found.lights, open.pixels());
  }
  SolvedSet set = solveUneven(matte, photographs, fields, plain, progress.part(kTaken, 1));
  if (fields.lens)
    for (Image& highlight : found.lights) fields.lens->takeFrom(highlight);
  set.report->message += wordsFor(pass, found.part);
  addHighlights(std::move(found), options.highlights, set);
  if (pass.reversed)
    set.report->warnings.emplace_back(
        "the crossed photographs are brighter than the others: they seem to be the ones with the highlights "
        "(\"polarisation\"), or their exposure was not told");
  const std::vector<std::string> lost = shiftWarnings(shifts);
  set.report->warnings.insert(set.report->warnings.end(), lost.begin(), lost.end());
  set.report->shifts = std::move(shifts);
  set.report->options = jsonFromSolveOptions(options);
  set.report->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  set.capture = capture;
  return set;
}

}  // namespace swaplight
