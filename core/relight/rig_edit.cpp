#include "core/relight/rig_edit.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/capture/capture_pixels.h"
#include "core/color/srgb.h"
#include "core/ocio/convert_color.h"

namespace swaplight {
namespace {

constexpr float kMostGain = 16;
constexpr float kDarkest = 1e-6F;  // below, a channel of a pixel tells nothing

LightColor linearColor(const Rgb& rec709) {
  LightColor color;
  color.kind = LightColor::Kind::LinearRgb;
  color.value = glm::max(rec709, Rgb(0));
  return color;
}

}  // namespace

Rig rigOfShot(const ColorConfig& config, Rig rig, const SolvedSet& set, size_t shot) {
  const Shot& taken = set.capture.shots.at(shot);
  for (size_t i = 0; i < rig.lights.size() && i < taken.lightColors.size(); ++i) {
    if (!taken.lightColors[i]) continue;
    LightSetting& light = rig.lights[i];
    light.color = linearColor(
        convertColor(config, *taken.lightColors[i], linearSpaceOf(set.capture.colorSpace), "lin_rec709"));
    light.stops = std::clamp(taken.exposureStops, -kMostStops, kMostStops);
    light.multiplier = 1;
    light.on = true;
    light.solo = light.mute = false;
  }
  return rig;
}

LightSetting resetLight(const LightSetting& setting) {
  LightSetting fresh;
  fresh.light = setting.light;
  fresh.role = setting.role;
  fresh.label = setting.label;
  fresh.group = setting.group;
  fresh.ratioLock = setting.ratioLock;
  return fresh;
}

Rig unitWhiteRig(Rig rig) {
  for (LightSetting& light : rig.lights) light = resetLight(light);
  for (LightGroup& group : rig.groups) group = {group.name, 0, true};
  rig.ambient = 1;
  return rig;
}

Rig allOffRig(Rig rig) {
  for (LightSetting& light : rig.lights) light.on = false;
  return rig;
}

LightSetting pastedLight(const LightSetting& onto, const LightSetting& copied) {
  LightSetting pasted = onto;
  pasted.color = copied.color;
  pasted.stops = copied.stops;
  pasted.multiplier = copied.multiplier;
  pasted.on = copied.on;
  return pasted;
}

Rig addStops(Rig rig, std::span<const size_t> lights, float stops) {
  const bool locked =
      std::any_of(lights.begin(), lights.end(), [&](size_t i) { return rig.lights.at(i).ratioLock; });
  for (size_t i = 0; i < rig.lights.size(); ++i) {
    const bool named = std::find(lights.begin(), lights.end(), i) != lights.end();
    float& light = rig.lights[i].stops;
    if (named || (locked && rig.lights[i].ratioLock))
      light = std::clamp(light + stops, -kMostStops, kMostStops);
  }
  return rig;
}

PixelShares pixelShares(const SolvedSet& set, int x, int y) {
  const auto at = [&](const Image& image) {
    const ImageView view = image.view();
    return Rgb(view.at(0, x, y), view.at(1, x, y), view.at(2, x, y));
  };
  PixelShares shares;
  for (const Image& contribution : set.contributions) shares.lights.push_back(at(contribution));
  if (set.ambient) shares.ambient = at(*set.ambient);
  return shares;
}

std::vector<Rgb> relitShares(const ColorConfig& config, const Rig& rig, const PixelShares& shares,
                             const std::string& colorSpace) {
  std::vector<Rgb> given = rigFactors(config, rig, colorSpace);
  for (size_t i = 0; i < given.size(); ++i) given[i] *= shares.of(i);
  given.push_back(rig.ambient * shares.ambient);
  return given;
}

LightColor lightColorOfPixel(const ColorConfig& config, const Rgb& pixel, const std::string& colorSpace) {
  const Rgb linear = glm::max(convertColor(config, pixel, colorSpace, "lin_rec709"), Rgb(0));
  const float brightest = std::max({linear.r, linear.g, linear.b});
  LightColor color;
  if (!(brightest > 0)) return color;
  color.kind = LightColor::Kind::Hex;
  color.value = srgbFromLinear(linear / brightest);
  return color;
}

std::optional<Rig> neutralizePixel(const ColorConfig& config, Rig rig, const PixelShares& shares,
                                   std::span<const size_t> chosen, const std::string& colorSpace) {
  const std::vector<Rgb> factors = rigFactors(config, rig, colorSpace);
  Rgb byChosen(0);
  Rgb byOthers = rig.ambient * shares.ambient;
  for (size_t i = 0; i < factors.size(); ++i) {
    const bool isChosen = std::find(chosen.begin(), chosen.end(), i) != chosen.end();
    (isChosen ? byChosen : byOthers) += factors[i] * shares.of(i);
  }
  if (std::min({byChosen.r, byChosen.g, byChosen.b}) < kDarkest) return std::nullopt;
  const float level = (byChosen.r + byChosen.g + byChosen.b + byOthers.r + byOthers.g + byOthers.b) / 3;
  const Rgb gain = glm::clamp((Rgb(level) - byOthers) / byChosen, Rgb(1 / kMostGain), Rgb(kMostGain));
  for (const size_t i : chosen) {
    LightSetting& light = rig.lights.at(i);
    const Rgb inSet = gain * convertColor(config, colorFactor(light.color), "lin_rec709", colorSpace);
    light.color = linearColor(convertColor(config, inSet, colorSpace, "lin_rec709"));
  }
  return rig;
}

}  // namespace swaplight
