#include "core/relight/rig.h"

#include <algorithm>
#include <cmath>

#include "core/capture/no_such_light.h"
#include "core/color/hsv.h"
#include "core/color/srgb.h"
#include "core/lamp/kelvin.h"
#include "core/lamp/lamp.h"
#include "core/relight/brightness.h"

namespace swaplight {
namespace {

Lamp lampOf(const LightColor& color) {
  switch (color.kind) {
    case LightColor::Kind::Hex:
      return Lamp::colored(linearFromSrgb(color.value));
    case LightColor::Kind::LinearRgb:
      return Lamp::colored(color.value);
    case LightColor::Kind::Hsv:
      return Lamp::colored(linearFromSrgb(rgbFromHsv(color.value)));
    case LightColor::Kind::Kelvin:
      return Lamp::white(color.kelvin);
    case LightColor::Kind::White:
      break;
  }
  return Lamp::white(kD65Kelvin);
}

std::vector<std::string> knownLights(const Rig& rig) {
  std::vector<std::string> names;
  for (const LightSetting& light : rig.lights) names.push_back(light.light);
  return names;
}

}  // namespace

Rig defaultRig(std::span<const std::string> lightNames) {
  Rig rig;
  for (const std::string& name : lightNames) {
    rig.lights.emplace_back();
    rig.lights.back().light = name;
  }
  return rig;
}

Rig defaultRig(const Capture& capture) {
  Rig rig;
  for (const Light& light : capture.lights) {
    rig.lights.emplace_back();
    rig.lights.back().light = light.name;
    rig.lights.back().role = light.role;
  }
  return rig;
}

LightSetting& findLight(Rig& rig, const std::string& name) {
  const auto found = std::find_if(rig.lights.begin(), rig.lights.end(),
                                  [&](const LightSetting& light) { return light.light == name; });
  if (found == rig.lights.end()) throw noSuchLight("", name, knownLights(rig));
  return *found;
}

Rig rigFor(const Capture& capture, const Rig& rig) {
  Rig fitted = defaultRig(capture);
  fitted.ambient = rig.ambient;
  fitted.groups = rig.groups;
  for (const LightSetting& light : rig.lights) findLight(fitted, light.light) = light;
  return fitted;
}

Rgb colorFactor(const LightColor& color) {
  Lamp lamp = lampOf(color);
  if (!color.gel.empty()) lamp.through(findGel(color.gel));
  if (color.green != 0) lamp.addGreen(color.green);
  return lamp.color();
}

Rgb lightFactor(const LightSetting& setting) {
  if (!setting.on) return Rgb(0);
  return brightnessLimited(colorFactor(setting.color) * (std::exp2(setting.stops) * setting.multiplier));
}

}  // namespace swaplight
