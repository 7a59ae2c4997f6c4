#include "core/relight/rig_animation.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"
#include "core/relight/setting.h"

namespace swaplight {
namespace {

float mixed(float a, float b, float t) {
  return a + t * (b - a);
}

LightColor mixedColor(const LightColor& a, const LightColor& b, float t) {
  if (a == b) return a;
  using Kind = LightColor::Kind;
  if (a.kind == Kind::Kelvin && b.kind == Kind::Kelvin && a.gel == b.gel) {
    LightColor color = a;
    color.kelvin = 1 / mixed(1 / a.kelvin, 1 / b.kelvin, t);
    color.green = mixed(a.green, b.green, t);
    return color;
  }
  LightColor color;
  color.kind = Kind::LinearRgb;
  color.value = colorFactor(a) * (1 - t) + colorFactor(b) * t;
  return color;
}

LightSetting mixedSetting(const LightSetting& a, const LightSetting& b, float t) {
  if (a.on != b.on) {  // to or from nothing: in a straight line of light
    LightSetting lit = a.on ? a : b;
    lit.multiplier *= a.on ? 1 - t : t;
    return lit;
  }
  LightSetting setting = a;
  setting.color = mixedColor(a.color, b.color, t);
  setting.stops = mixed(a.stops, b.stops, t);
  setting.multiplier = mixed(a.multiplier, b.multiplier, t);
  return setting;
}

LightSetting atKey(LightSetting light, const RigAnimation::Key& key) {
  try {
    applySetting(light, key.setting);
  } catch (const InputError& error) {
    throw InputError("{} at frame {}: {}", light.light, key.frame, error.what());
  }
  return light;
}

LightSetting settingAt(const LightSetting& light, const std::vector<RigAnimation::Key>& keys,
                       RigAnimation::Between between, int frame) {
  const auto next =
      std::find_if(keys.begin(), keys.end(), [&](const auto& key) { return key.frame > frame; });
  if (next == keys.begin()) return atKey(light, keys.front());
  const RigAnimation::Key& before = *(next - 1);
  LightSetting from = atKey(light, before);
  if (next == keys.end() || before.frame == frame) return from;
  float t = static_cast<float>(frame - before.frame) / static_cast<float>(next->frame - before.frame);
  if (between == RigAnimation::Between::Smooth) t = t * t * (3 - 2 * t);
  return mixedSetting(from, atKey(light, *next), t);
}

bool isAmbient(const Rig& rig, const std::string& name) {
  return name == kAmbientName &&
         std::none_of(rig.lights.begin(), rig.lights.end(),
                      [](const LightSetting& light) { return light.light == kAmbientName; });
}

/// The ambient light's level, as that of a light without colour.
float ambientAt(float level, const std::vector<RigAnimation::Key>& keys, RigAnimation::Between between,
                int frame) {
  LightSetting ambient;
  ambient.light = kAmbientName;
  ambient.multiplier = level;
  ambient = settingAt(ambient, keys, between, frame);
  if (ambient.color != LightColor())
    throw InputError("ambient at frame {}: has a level and no colour: write x0.5, 50%, -1st or off", frame);
  return ambient.on ? ambient.multiplier * std::exp2(ambient.stops) : 0;
}

}  // namespace

void RigAnimation::add(const std::string& light, Key key) {
  std::vector<Key>& keys = lights[light];
  const auto place =
      std::find_if(keys.begin(), keys.end(), [&](const Key& other) { return other.frame >= key.frame; });
  if (place != keys.end() && place->frame == key.frame)
    *place = std::move(key);
  else
    keys.insert(place, std::move(key));
}

Rig rigAt(const Rig& rig, const RigAnimation& animation, int frame) {
  Rig now = rig;
  for (const auto& [name, keys] : animation.lights) {
    if (isAmbient(rig, name)) {
      if (!keys.empty()) now.ambient = ambientAt(rig.ambient, keys, animation.between, frame);
      continue;
    }
    LightSetting& light = findLight(now, name);
    if (!keys.empty()) light = settingAt(light, keys, animation.between, frame);
  }
  return now;
}

RigAnimation::Between betweenFromName(const std::string& name) {
  if (name == "linear") return RigAnimation::Between::Linear;
  if (name == "smooth") return RigAnimation::Between::Smooth;
  throw InputError("'{}' is no way from key to key; known: linear, smooth", name);
}

RigAnimation animationFromJson(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  RigAnimation animation;
  animation.between = betweenFromName(fields.text("between").value_or("linear"));
  const Json* lights = fields.find("lights");
  if (!lights || !lights->is_object())
    throw InputError(
        "{}: \"lights\" is missing: write {{\"key\": [{{\"frame\": 1, \"setting\": \"+1st\"}}]}}", where);
  for (const auto& [name, keys] : lights->items())
    for (const Json& item : keys) {
      JsonFields key(item, fmt::format("{}: a key of {}", where, name));
      const auto frame = key.number("frame", -1e9, 1e9);
      const auto setting = key.text("setting");
      if (!frame || !setting)
        throw InputError("{}: give {{\"frame\": 1, \"setting\": \"3200K,+1st\"}}", key.where());
      animation.add(name, {static_cast<int>(*frame), *setting});
    }
  return animation;
}

Json jsonFromAnimation(const RigAnimation& animation) {
  Json lights = Json::object();
  for (const auto& [name, keys] : animation.lights)
    for (const RigAnimation::Key& key : keys)
      lights[name].push_back({{"frame", key.frame}, {"setting", key.setting}});
  return {{"between", animation.between == RigAnimation::Between::Smooth ? "smooth" : "linear"},
          {"lights", lights}};
}

}  // namespace swaplight
