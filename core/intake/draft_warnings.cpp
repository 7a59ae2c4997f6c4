#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/quantile.h"
#include "core/intake/capture_draft.h"
#include "core/solve/model/lighting_matrix.h"
#include "core/solve/model/unknown_color.h"
#include "core/solve/registration/align_shots.h"

namespace swaplight {
namespace {

/// Pixels that the camera has moved, worth a word: lights that change sides move the lit edges of a surface's
/// relief, real gels on sets that stood still by up to 0.33.
constexpr float kMovedPixels = 0.35F;
constexpr float kDarkCapture = 0.125F;  ///< of what the camera can record: the brightest parts of all shots
constexpr size_t kDarknessSample = 20000;
constexpr double kClippedArea = 0.002;  ///< of a shot, that is worth a word

/// The part of the pixels in which a channel is saturated in all exposures of a lighting.
double clippedPart(const CapturePixels& pixels, size_t firstShot, size_t length) {
  const size_t count = pixels.shots[firstShot].pixelCount();
  size_t clipped = 0;
  for (size_t p = 0; p < count; ++p) {
    bool lost = false;
    for (int c = 0; c < 3 && !lost; ++c) {
      lost = true;
      for (size_t k = firstShot; k < firstShot + length; ++k)
        lost = lost && pixels.shots[k].plane(c)[p] >= pixels.clipLevel[k];
    }
    clipped += lost ? 1 : 0;
  }
  return static_cast<double>(clipped) / static_cast<double>(std::max<size_t>(1, count));
}

void clippingWarnings(const CaptureDraft& draft, const CapturePixels& pixels,
                      std::vector<std::string>& warnings) {
  const auto length = static_cast<size_t>(draft.brackets.length);
  for (size_t k = 0; k < pixels.shots.size(); k += length) {
    const double part = clippedPart(pixels, k, length);
    if (part <= kClippedArea) continue;
    const std::string& file = draft.folder.shots[k].file;
    warnings.push_back(
        length > 1 ? fmt::format("{}: {:.1f} % of the picture is clipped in all {} exposures: "
                                 "add a shorter one",
                                 file, 100 * part, length)
                   : fmt::format("{}: {:.1f} % of the picture is clipped: expose less", file, 100 * part));
  }
}

/// Of files that have a largest value. Noise is what limits a solve, and a dark picture is mostly noise.
void darknessWarning(const CapturePixels& pixels, std::vector<std::string>& warnings) {
  float brightest = 0;
  for (size_t k = 0; k < pixels.shots.size(); ++k) {
    if (!std::isfinite(pixels.clipLevel[k])) return;
    std::vector<float> values;
    const Image& shot = pixels.shots[k];
    const size_t step = std::max<size_t>(1, shot.pixelCount() / kDarknessSample);
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < shot.pixelCount(); p += step)
        if (std::isfinite(shot.plane(c)[p])) values.push_back(shot.plane(c)[p]);
    if (!values.empty())
      brightest = std::max(brightest, quantile(std::span(values), .995F) / pixels.clipLevel[k]);
  }
  if (brightest > 0 && brightest < kDarkCapture)
    warnings.push_back(fmt::format(
        "the brightest parts of the photographs lie {:.0f} stops below what the camera can record: expose up "
        "to {:.0f} stops more",
        std::floor(-std::log2(brightest)), std::floor(-std::log2(brightest)) - 1));
}

void exposureWarnings(const CaptureDraft& draft, std::vector<std::string>& warnings) {
  if (!draft.brackets.stops.empty()) return;  // said by Brackets::words
  const std::vector<FoundShot>& shots = draft.folder.shots;
  const Capture capture = captureOf(draft);
  for (size_t k = 1; k < shots.size(); ++k)
    if (capture.shots[k].exposureStops != 0)
      warnings.push_back(fmt::format("{} was exposed {:+.2f} stops relative to {}: compensated",
                                     shots[k].file, capture.shots[k].exposureStops, shots[0].file));
  const auto silent = std::count_if(shots.begin(), shots.end(),
                                    [](const FoundShot& shot) { return !shot.exposureStops.has_value(); });
  if (silent > 0 && static_cast<size_t>(silent) < shots.size())
    warnings.push_back(
        fmt::format("{} of {} photographs have no exposure data: the same exposure is assumed for all",
                    silent, shots.size()));
}

constexpr const char* kOneNumberOpen =
    ", but two photographs leave one number of it open; a third one under other colours settles it, or a "
    "place that one lamp alone lights";

/// "?a, that of fill in 1.exr and key in 2.exr,"; "the colour of fill in 1.exr".
std::string placeWords(const Capture& capture, const UnknownColor& unknown) {
  std::vector<std::string> places;
  for (const int entry : unknown.entries)
    places.push_back(fmt::format("{} in {}",
                                 capture.lights[static_cast<size_t>(entry % capture.lightCount())].name,
                                 capture.shots[static_cast<size_t>(entry / capture.lightCount())].image));
  const std::string all = fmt::format("the colour of {}", fmt::join(places, ", "));
  return unknown.name.empty() ? all : fmt::format("{}, {},", unknown.name, all);
}

}  // namespace

std::vector<std::string> pictureWarnings(const CaptureDraft& draft, const CapturePixels& pixels) {
  std::vector<std::string> warnings = pixels.warnings;
  const std::vector<FoundShot>& shots = draft.folder.shots;
  clippingWarnings(draft, pixels, warnings);
  darknessWarning(pixels, warnings);
  for (std::string& warning : bracketWarnings(draft.folder, pixels, draft.brackets))
    warnings.push_back(std::move(warning));
  const std::vector<ShotShift> shifts = measureShifts(pixels);
  for (size_t k = 0; k < shifts.size(); ++k)
    if (const float moved = farthestMove({shifts[k]}, pixels.width(), pixels.height()); moved > kMovedPixels)
      warnings.push_back(fmt::format(
          "{}: the camera {} by {:.1f} pixels against {}: align the photographs when solving", shots[k].file,
          shifts[k].isTurned() ? "moved and turned" : "moved", moved, shots[0].file));
  std::vector<std::string> files;
  for (const FoundShot& shot : shots) files.push_back(shot.file);
  if (farthestMove(shifts, pixels.width(), pixels.height()) > kMovedPixels)  // aligning is advised
    for (std::string& warning : shiftWarnings(shifts, files)) warnings.push_back(std::move(warning));
  exposureWarnings(draft, warnings);
  return warnings;
}

std::vector<std::string> colorWarnings(const CaptureDraft& draft) {
  std::vector<std::string> warnings;
  for (const auto& [light, name] : draft.folder.flats)
    if (std::find(draft.lights.begin(), draft.lights.end(), light) == draft.lights.end())
      warnings.push_back(fmt::format("{} is not used: there is no light \"{}\"", name, light));
  const Capture capture = captureOf(draft);
  const LightingMatrix lighting = lightingFromCapture(capture);
  const std::vector<UnknownColor> unknown = unknownColorsOf(capture);
  const auto swapped = swappedColorOf(capture);
  const bool open = swapped && swapped->open;
  std::vector<int> places(lighting.colors.size(), -1);
  for (size_t j = 0; j < unknown.size(); ++j) {
    for (const int entry : unknown[j].entries) places[static_cast<size_t>(entry)] = static_cast<int>(j);
    warnings.push_back(fmt::format("{} is unknown: it is estimated from the pictures{}",
                                   placeWords(capture, unknown[j]), open ? kOneNumberOpen : ""));
  }
  try {
    checkSolvable(lighting, "the colours", places);
    if (unknown.empty())
      for (const std::string& advice : conditioningOf(lighting).advice) warnings.push_back(advice);
  } catch (const InputError& error) {
    warnings.emplace_back(error.what());
  }
  return warnings;
}

}  // namespace swaplight
