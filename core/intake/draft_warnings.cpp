#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/intake/capture_draft.h"
#include "core/solve/model/lighting_matrix.h"
#include "core/solve/registration/align_shots.h"

namespace swaplight {
namespace {

/// Pixels that the camera has moved, worth a word: lights that change sides move the lit edges of a surface's
/// relief, real gels on sets that stood still by up to 0.33.
constexpr float kMovedPixels = 0.35F;
constexpr double kClippedArea = 0.002;  ///< of a shot, that is worth a word

/// The part of a shot's pixels that are saturated in some channel.
double clippedPart(const Image& shot, float level) {
  size_t clipped = 0;
  for (size_t p = 0; p < shot.pixelCount(); ++p)
    clipped += shot.plane(0)[p] >= level || shot.plane(1)[p] >= level || shot.plane(2)[p] >= level ? 1 : 0;
  return static_cast<double>(clipped) / static_cast<double>(std::max<size_t>(1, shot.pixelCount()));
}

void exposureWarnings(const CaptureDraft& draft, std::vector<std::string>& warnings) {
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

}  // namespace

std::vector<std::string> pictureWarnings(const CaptureDraft& draft, const CapturePixels& pixels) {
  std::vector<std::string> warnings = pixels.warnings;
  const std::vector<FoundShot>& shots = draft.folder.shots;
  for (size_t k = 0; k < pixels.shots.size(); ++k) {
    const double part = clippedPart(pixels.shots[k], pixels.clipLevel[k]);
    if (part > kClippedArea)
      warnings.push_back(
          fmt::format("{}: {:.1f} % of the picture is clipped: expose less", shots[k].file, 100 * part));
  }
  const std::vector<ShotShift> shifts = measureShifts(pixels);
  for (size_t k = 0; k < shifts.size(); ++k)
    if (worthMoving(shifts[k]) && std::hypot(shifts[k].x, shifts[k].y) > kMovedPixels)
      warnings.push_back(fmt::format(
          "{}: the camera moved by {:.1f}, {:.1f} pixels against {}: align the photographs when solving",
          shots[k].file, shifts[k].x, shifts[k].y, shots[0].file));
  for (std::string& warning : shiftWarnings(shifts)) warnings.push_back(std::move(warning));
  exposureWarnings(draft, warnings);
  return warnings;
}

std::vector<std::string> colorWarnings(const CaptureDraft& draft) {
  std::vector<std::string> warnings;
  const Capture capture = captureOf(draft);
  std::vector<int> unknown;
  const LightingMatrix lighting = lightingFromCapture(capture, &unknown);
  for (const int entry : unknown) {
    const int shot = entry / lighting.lights, light = entry % lighting.lights;
    const Rgb& start = lighting.color(shot, light);
    warnings.push_back(
        fmt::format("the colour of {} in {} is unknown: it is estimated from the pictures, starting at "
                    "{:.3f}/{:.3f}/{:.3f}",
                    lighting.names[static_cast<size_t>(light)],
                    capture.shots[static_cast<size_t>(shot)].image, start.r, start.g, start.b));
  }
  try {
    checkSolvable(lighting, "the colours");
    if (unknown.empty())
      for (const std::string& advice : conditioningOf(lighting).advice) warnings.push_back(advice);
  } catch (const InputError& error) {
    warnings.emplace_back(error.what());
  }
  return warnings;
}

}  // namespace swaplight
