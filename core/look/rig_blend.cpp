#include "core/look/rig_blend.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace swaplight {
namespace {

bool isBlack(const Rgb& factor) {
  return std::max({factor.r, factor.g, factor.b}) <= 0;
}

/// `to` for the lights of `from`, with their names and roles.
Rig endOf(const Rig& from, const Rig& to) {
  Rig end = to;
  end.lights = from.lights;
  for (LightSetting& light : end.lights) {
    const auto known = std::find_if(to.lights.begin(), to.lights.end(),
                                    [&](const LightSetting& other) { return other.light == light.light; });
    if (known == to.lights.end()) continue;
    const LightSetting mine = light;
    light = *known;
    light.role = mine.role;
    light.label = mine.label;
  }
  return end;
}

/// Sets dimmer and colour so that the light's factor is this one, in the given colour where it has one.
void setFactor(LightSetting& light, const Rgb& factor, const LightColor* color) {
  light.solo = light.mute = false;
  light.multiplier = 1;
  light.on = !isBlack(factor);
  if (!light.on) return;
  float times = std::max({factor.r, factor.g, factor.b});
  if (color) {
    const Rgb whole = colorFactor(*color);
    times = (factor.r + factor.g + factor.b) / (whole.r + whole.g + whole.b);
    light.color = *color;
  } else {
    light.color = {};
    light.color.kind = LightColor::Kind::LinearRgb;
    light.color.value = factor / times;
  }
  light.stops = std::clamp(std::log2(times), -kMostStops, kMostStops);
}

}  // namespace

Rig blendRigs(const Rig& from, const Rig& to, float amount) {
  if (amount <= 0) return from;
  Rig end = endOf(from, to);
  if (amount >= 1) return end;
  const std::vector<Rgb> starts = rigFactors(from), ends = rigFactors(end);
  Rig blended = from;
  for (LightGroup& group : blended.groups) group = {group.name, 0, true};
  for (size_t i = 0; i < blended.lights.size(); ++i) {
    // A light that only comes or goes, or is dimmed, keeps its colour.
    const LightColor &first = from.lights[i].color, &last = end.lights[i].color;
    const LightColor* color = nullptr;
    if (first == last || isBlack(ends[i]))
      color = &first;
    else if (isBlack(starts[i]))
      color = &last;
    setFactor(blended.lights[i], glm::mix(starts[i], ends[i], amount), color);
  }
  blended.ambient = glm::mix(from.ambient, to.ambient, amount);
  return blended;
}

}  // namespace swaplight
