#include "core/export/filtered_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/export/filtered_frame.h"

namespace swaplight {
namespace {

/// Light under the look, in the primaries that it had.
Image seenLight(const ColorConfig& config, const Image& light, FrameFilter& look, int frameNumber,
                const Progress& progress) {
  const std::string space = light.spec().colorSpace;
  Image seen = lightOf(look.apply({light.clone(), FilterSpace::SceneLinear},
                                  displayFromScene(config, space, {}), frameNumber, progress));
  if (seen.spec().colorSpace != space) config.convert(seen.span(), seen.spec().colorSpace, space);
  seen.setColorSpace(space);
  return seen;
}

/// The picture with what is saturated at half its value; nothing where nothing is.
std::optional<Image> withoutSaturation(const Image& shot, float clip) {
  Image darker = shot.clone();
  bool any = false;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < darker.pixelCount(); ++p) {
      float& value = darker.plane(c)[p];
      if (value < clip || !std::isfinite(value)) continue;
      any = true;
      value /= 2;
    }
  if (!any) return std::nullopt;
  return darker;
}

/// A value that the look makes from saturated ones is not known either: it changes with them.
bool followsSaturation(float seen, float ofDarker) {
  constexpr float kShare = 0.01F, kDark = 1e-4F;
  return std::abs(seen - ofDarker) > kShare * std::max(std::abs(seen), kDark);
}

/// Gives the shot's new clip level.
float filterShot(const ColorConfig& config, Image& shot, float clip, FrameFilter& look, int number,
                 const Progress& progress) {
  Image seen = seenLight(config, shot, look, number, progress.part(0, 0.5F));
  const std::optional<Image> darker = withoutSaturation(shot, clip);
  std::optional<Image> seenDarker;
  if (darker) seenDarker = seenLight(config, *darker, look, number, progress.part(0.5F, 1));
  float brightest = 0;
  for (int c = 0; c < 3; ++c)
    brightest = std::max(brightest, *std::max_element(seen.plane(c), seen.plane(c) + seen.pixelCount()));
  const float newClip = darker ? 2 * brightest + 1 : std::numeric_limits<float>::infinity();
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < seen.pixelCount(); ++p) {
      const float before = shot.plane(c)[p];
      float& value = seen.plane(c)[p];
      if (!std::isfinite(before))
        value = before;
      else if (before >= clip || (seenDarker && followsSaturation(value, seenDarker->plane(c)[p])))
        value = newClip;
    }
  shot = std::move(seen);
  return newClip;
}

}  // namespace

void filterShots(const ColorConfig& config, CapturePixels& pixels, FrameFilter& look,
                 const Progress& progress) {
  const auto count = static_cast<float>(pixels.shots.size() + 1);
  for (size_t k = 0; k < pixels.shots.size(); ++k)
    pixels.clipLevel[k] =
        filterShot(config, pixels.shots[k], pixels.clipLevel[k], look, static_cast<int>(k),
                   progress.part(static_cast<float>(k) / count, static_cast<float>(k + 1) / count));
  if (pixels.ambient) {
    Image seen = seenLight(config, *pixels.ambient, look, 0, progress.part((count - 1) / count, 1));
    pixels.ambient = std::move(seen);
  }
  pixels.warnings.push_back(
      "the photographs are solved as the camera look \"" + look.pipeline().name +
      "\" makes them: lights add up in light alone, so a filter that is not linear in light shows in the "
      "residual and in beta");
}

void filterLight(const ColorConfig& config, SolvedSet& set, size_t light, FrameFilter& look,
                 const Progress& progress) {
  Image& contribution = set.contributions.at(light);
  Image seen = seenLight(config, contribution, look, 0, progress);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < seen.pixelCount(); ++p) seen.plane(c)[p] = std::max(seen.plane(c)[p], 0.0F);
  contribution = std::move(seen);
  if (!set.highlights.empty()) set.highlights[light] = Image(contribution.spec(), 0);  // none is known now
  updateBeta(set);
}

}  // namespace swaplight
