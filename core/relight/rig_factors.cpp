#include <algorithm>
#include <cmath>

#include "core/ocio/color_config.h"
#include "core/relight/brightness.h"
#include "core/relight/rig.h"

namespace swaplight {

namespace {

float groupFactor(const Rig& rig, const LightSetting& light) {
  if (light.group.empty()) return 1;
  const auto group = std::find_if(rig.groups.begin(), rig.groups.end(),
                                  [&](const LightGroup& other) { return other.name == light.group; });
  if (group == rig.groups.end()) return 1;
  return group->on ? std::exp2(group->stops) : 0;
}

}  // namespace

std::vector<Rgb> rigFactors(const Rig& rig) {
  const bool anySolo =
      std::any_of(rig.lights.begin(), rig.lights.end(), [](const LightSetting& light) { return light.solo; });
  std::vector<Rgb> factors;
  for (const LightSetting& light : rig.lights)
    factors.push_back(light.mute || (anySolo && !light.solo)
                          ? Rgb(0)
                          : brightnessLimited(groupFactor(rig, light) * lightFactor(light)));
  return factors;
}

std::vector<Rgb> rigFactors(const ColorConfig& config, const Rig& rig, const std::string& colorSpace) {
  std::vector<Rgb> factors = rigFactors(rig);
  if (colorSpace == "lin_rec709" || factors.empty()) return factors;
  Image colors(ImageSpec::rgb(static_cast<int>(factors.size()), 1));
  for (size_t i = 0; i < factors.size(); ++i)
    for (int c = 0; c < 3; ++c) colors.plane(c)[i] = factors[i][c];
  config.convert(colors.span(), "lin_rec709", colorSpace);
  for (size_t i = 0; i < factors.size(); ++i)
    for (int c = 0; c < 3; ++c) factors[i][c] = std::max(0.0f, colors.plane(c)[i]);
  return factors;
}

}  // namespace swaplight
