#include "core/solve/solve_crossed.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/solve/even_lamps.h"
#include "core/solve/highlights/crossed_pass.h"
#include "core/solve/highlights/highlight_light.h"
#include "core/solve/model/crossed_shots.h"
#include "core/solve/model/lighting_matrix.h"
#include "core/solve/model/unknown_color.h"
#include "core/solve/pixel_flags.h"
#include "core/solve/registration/align_shots.h"
#include "core/solve/registration/moved_shots.h"
#include "core/solve/signal_scale.h"

namespace swaplight {
namespace {

constexpr float kFound = 0.35F;       // of the work, when the matte set is known ...
constexpr float kTaken = 0.45F;       // ... and when the highlights are
constexpr double kWorthwhile = 1e-4;  // part of the picture that has to show highlights

void check(const Capture& capture, const FlatFields& fields) {
  if (!unknownColorsOf(capture).empty())
    throw InputError(
        "{}: a light's colour is unknown, and some photographs are crossed: what the polarisers take and the "
        "colour cannot be told apart. Measure the colour, or leave the crossed photographs out.",
        capture.calledName());
  if (!fields.lamps.empty())
    throw InputError(
        "{}: has flat fields of its lamps and crossed photographs: both are not solved together. Leave "
        "one of them out.",
        capture.calledName());
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

/// The crossed shots, by themselves. Throws where they do not tell the lights apart.
Capture crossedShots(const Capture& capture, const Rgb& pass) {
  Capture crossed = withoutFilters(shotsOf(capture, true), pass);
  try {
    checkSolvable(lightingFromCapture(crossed), capture.calledName());
  } catch (const InputError& error) {
    throw InputError("{}: its crossed photographs must tell the lights apart by themselves: {}",
                     capture.calledName(), error.what());
  }
  return crossed;
}

/// Photographed ambient light passes the crossed filter as each channel does, and is taken off by the mean of
/// them (withoutFilters): what lies between is put into the photographs.
void evenAmbient(const Capture& capture, const Rgb& pass, CapturePixels& photographs) {
  if (!photographs.ambient) return;
  const float mean = (pass.r + pass.g + pass.b) / 3;
  for (size_t k = 0; k < capture.shots.size(); ++k)
    for (int c = 0; c < 3 && capture.shots[k].crossed; ++c) {
      const float part = (mean - pass[c]) * std::exp2(capture.shots[k].exposureStops);
      float* values = photographs.shots[k].plane(c);
      const float* ambient = photographs.ambient->plane(c);
      for (size_t p = 0; p < photographs.ambient->pixelCount(); ++p)
        if (values[p] < photographs.clipLevel[k]) values[p] += part * ambient[p];
    }
}

/// None where a moved photograph shows nothing.
void dropOutside(const std::vector<ShotShift>& shifts, HighlightLight& found) {
  for (Image& light : found.lights)
    for (int y = 0; y < light.height(); ++y)
      for (int x = 0; x < light.width(); ++x)
        if (outsideAny(shifts, x, y, light.width(), light.height()))
          for (int c = 0; c < 3; ++c) light.span().at(c, x, y) = 0;
}

void flagClipped(const std::vector<uint8_t>& clipped, SolvedSet& set) {
  float* flags = set.quality.plane(kFlags);
  size_t count = 0;
  for (size_t p = 0; p < clipped.size(); ++p) {
    if (clipped[p]) flags[p] = static_cast<float>(static_cast<int>(flags[p]) | kClipped);
    count += (static_cast<int>(flags[p]) & kClipped) != 0;
  }
  set.report->clipped = count;
}

std::string wordsFor(const CrossedPass& pass, double part) {
  const std::string found =
      part < kWorthwhile ? "No highlights" : fmt::format("Highlights in {:.2f} % of the picture", 100 * part);
  return fmt::format(" {}, by crossed polarisers, which pass {:.0f} % of matte light.", found,
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
  fillDarkBeta(set);
  if (!keep || found.part < kWorthwhile) return;
  set.highlights = std::move(found.lights);
  set.report->highlights = found.part;
}

/// Of photographs around full scale.
SolvedSet solveAroundOne(const Capture& capture, CapturePixels photographs, const FlatFields& fields,
                         const SolveOptions& options, const Progress& progress) {
  SolveOptions plain = options;
  std::vector<ShotShift> shifts;
  if (std::exchange(plain.align, Remedy::Off) == Remedy::On) {
    progress.update(0, "Aligning the photographs");
    shifts = measureShifts(photographs, progress);
    if (std::any_of(shifts.begin(), shifts.end(), worthMoving)) photographs = movedShots(photographs, shifts);
  }
  const bool moved = std::any_of(shifts.begin(), shifts.end(), worthMoving);
  const CrossedPass pass = crossedPass(capture, photographs);
  evenAmbient(capture, pass.part, photographs);
  HighlightLight found;
  {
    const SolvedSet without = [&] {
      BorrowedShots crossed(capture, true, photographs);
      SolveOptions asTold = plain;  // what the open shots are compared with has the same colours
      asTold.field = asTold.refineColors = false;
      return solve(crossedShots(capture, pass.part), crossed.pixels(), asTold, progress.part(0, kFound));
    }();
    const Capture seen = shotsOf(capture, false);
    BorrowedShots open(capture, false, photographs);
    found = highlightLight(seen, open.pixels(), without, progress.part(kFound, kTaken));
    if (moved) dropOutside(shifts, found);
    takeHighlights(seen, found.lights, without, open.pixels());
  }
  SolvedSet set =
      solveUneven(withoutFilters(capture, pass.part), photographs, fields, plain, progress.part(kTaken, 1));
  if (fields.lens)
    for (Image& highlight : found.lights) fields.lens->takeFrom(highlight);
  set.report->message += wordsFor(pass, found.part);
  flagClipped(found.clipped, set);
  addHighlights(std::move(found), options.highlights, set);
  if (pass.reversed)
    set.report->warnings.emplace_back(
        "the crossed photographs are brighter than the others: they seem to be the ones with the highlights "
        "(\"polarisation\"), or their exposure was not told");
  const std::vector<std::string> lost = shiftWarnings(shifts, capture);
  set.report->warnings.insert(set.report->warnings.end(), lost.begin(), lost.end());
  if (moved) {
    flagOutside(shifts, set);
    set.report->message += " Photographs aligned.";
  }
  set.report->shifts = std::move(shifts);
  return set;
}

}  // namespace

SolvedSet solveCrossed(const Capture& capture, CapturePixels photographs, const FlatFields& fields,
                       const SolveOptions& options, const Progress& progress) {
  const auto started = std::chrono::steady_clock::now();
  options.check();
  check(capture, fields);
  const float scale = signalScale(photographs, capture.calledName());
  Capture scaled = capture;
  SolveOptions scaledOptions = options;
  for (auto* noise : {&scaled.noise, &scaledOptions.noise})
    if (*noise) *noise = scaledNoise(**noise, scale);
  if (scale != 1) photographs = scaledSignal(photographs, scale);
  SolvedSet set = solveAroundOne(scaled, std::move(photographs), fields, scaledOptions, progress);
  if (scale != 1) {
    unscale(set, scale);
    set.report->noise = scaledNoise(set.report->noise, 1 / scale);
  }
  set.capture = capture;
  set.report->options = jsonFromSolveOptions(options);
  set.report->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return set;
}

}  // namespace swaplight
