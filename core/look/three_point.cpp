#include "core/look/three_point.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/lamp/kelvin.h"
#include "core/ocio/luminance.h"

namespace swaplight {
namespace {

constexpr float kWarmPart = 2.0F / 3;
constexpr float kMiredOfWhite = 1e6F / static_cast<float>(kD65Kelvin);

std::optional<size_t> firstOfRole(const Rig& rig, Role role) {
  const std::vector<size_t> lights = lightsOfRole(rig, role);
  return lights.empty() ? std::nullopt : std::optional(lights.front());
}

float groupStops(const Rig& rig, const std::string& name) {
  for (const LightGroup& group : rig.groups)
    if (group.name == name) return group.stops;
  return 0;
}

/// Of a white; nothing for a colour.
std::optional<float> miredOf(const LightColor& color) {
  if (color.kind == LightColor::Kind::White) return kMiredOfWhite;
  if (color.kind == LightColor::Kind::Kelvin) return 1e6F / color.kelvin;
  return std::nullopt;
}

void makeWhite(Rig& rig, Role role, float mired) {
  for (const size_t i : lightsOfRole(rig, role)) {
    LightColor& color = rig.lights[i].color;
    color.kind = mired == kMiredOfWhite ? LightColor::Kind::White : LightColor::Kind::Kelvin;
    color.value = Rgb(1);
    color.kelvin = std::round(1e6F / mired);
  }
}

}  // namespace

std::vector<size_t> lightsOfRole(const Rig& rig, Role role) {
  std::vector<size_t> lights;
  for (size_t i = 0; i < rig.lights.size(); ++i)
    if (rig.lights[i].role == role) lights.push_back(i);
  return lights;
}

float settingStops(const Rig& rig, size_t light) {
  const LightSetting& setting = rig.lights[light];
  const float luminance = glm::dot(colorFactor(setting.color), kRec709Luminance) * setting.multiplier;
  return setting.stops + groupStops(rig, setting.group) + std::log2(std::max(luminance, 1e-9F));
}

std::optional<float> stopsOverRole(const Rig& rig, const LightRatios& ratios, Role role, Role other) {
  const std::optional<size_t> of = firstOfRole(rig, role), over = firstOfRole(rig, other);
  if (!of || !over) return std::nullopt;
  return ratios.stops(*of, *over) + settingStops(rig, *of) - settingStops(rig, *over);
}

Rig withStopsOverRole(Rig rig, const LightRatios& ratios, Role role, Role other, float stops) {
  const std::optional<float> now = stopsOverRole(rig, ratios, role, other);
  if (!now) return rig;
  for (const size_t i : lightsOfRole(rig, role)) {
    LightSetting& light = rig.lights[i];
    light.stops = std::clamp(light.stops + stops - *now, -kMostStops, kMostStops);
    light.on = true;
    light.mute = false;
  }
  return rig;
}

std::string ratioWords(float stops) {
  const float ratio = std::exp2(std::abs(stops));
  const float rounded = ratio < 9.95F ? std::round(10 * ratio) / 10 : std::round(ratio);
  return stops < 0 && rounded > 1 ? fmt::format("1:{:g}", rounded) : fmt::format("{:g}:1", rounded);
}

std::optional<float> warmCoolSplit(const Rig& rig) {
  const std::optional<size_t> key = firstOfRole(rig, Role::Key), fill = firstOfRole(rig, Role::Fill);
  if (!key || !fill) return std::nullopt;
  const std::optional<float> warm = miredOf(rig.lights[*key].color), cool = miredOf(rig.lights[*fill].color);
  if (!warm || !cool) return std::nullopt;
  return *warm - *cool;
}

Rig withWarmCoolSplit(Rig rig, float mired) {
  const float split = std::clamp(mired, -kMostSplit, kMostSplit);
  const float keyPart = split > 0 ? kWarmPart : 1 - kWarmPart;
  makeWhite(rig, Role::Key, kMiredOfWhite + keyPart * split);
  makeWhite(rig, Role::Fill, kMiredOfWhite - (1 - keyPart) * split);
  return rig;
}

}  // namespace swaplight
