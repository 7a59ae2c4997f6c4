#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"
#include "core/relight/rig.h"
#include "core/relight/setting.h"

namespace swaplight {
namespace {

constexpr const char* kFormat = "swaplight-rig";
constexpr int kVersion = 1;
constexpr size_t kMostLights = 64;
constexpr double kLargestFactor = 1e9;

LightSetting settingFromJson(const Json& json, const std::string& where, std::vector<std::string>* warnings) {
  JsonFields fields(json, where);
  LightSetting light;
  const auto name = fields.text("name");
  if (!name) throw InputError("{}: \"name\" is missing.", where);
  light.light = *name;
  fields.setWhere(fmt::format("{} ({})", where, *name));
  const auto color = fields.text("color");
  const auto role = fields.text("role");
  try {
    if (color) applySetting(light, *color);
    if (role) light.role = roleFromName(*role);
  } catch (const InputError& error) {
    throw InputError("{}: {}", fields.where(), error.what());
  }
  const auto number = [&](const char* key, double low, double high, float missing) {
    return static_cast<float>(fields.number(key, low, high).value_or(missing));
  };
  light.stops = number("stops", -kMostStops, kMostStops, light.stops);
  light.multiplier = number("multiplier", 0, kLargestFactor, light.multiplier);
  light.on = fields.boolean("on").value_or(light.on);
  light.solo = fields.boolean("solo").value_or(false);
  light.mute = fields.boolean("mute").value_or(false);
  light.ratioLock = fields.boolean("ratio_lock").value_or(false);
  light.label = fields.text("label").value_or("");
  light.group = fields.text("group").value_or("");
  if (warnings) fields.warnOfUnknown(*warnings);
  return light;
}

LightGroup groupFromJson(const Json& json, const std::string& where, std::vector<std::string>* warnings) {
  JsonFields fields(json, where);
  LightGroup group;
  group.name = fields.text("name").value_or("");
  if (group.name.empty()) throw InputError("{}: \"name\" is missing.", where);
  group.stops = static_cast<float>(fields.number("stops", -kMostStops, kMostStops).value_or(0));
  group.on = fields.boolean("on").value_or(true);
  if (warnings) fields.warnOfUnknown(*warnings);
  return group;
}

Json jsonFromSetting(const LightSetting& light) {
  Json json{{"name", light.light},
            {"role", roleName(light.role)},
            {"color", colorText(light.color)},
            {"stops", jsonNumber(light.stops)},
            {"multiplier", jsonNumber(light.multiplier)},
            {"on", light.on},
            {"solo", light.solo},
            {"mute", light.mute},
            {"ratio_lock", light.ratioLock}};
  if (!light.label.empty()) json["label"] = light.label;
  if (!light.group.empty()) json["group"] = light.group;
  return json;
}

}  // namespace

Json jsonFromRig(const Rig& rig) {
  Json lights = Json::array();
  for (const LightSetting& light : rig.lights) lights.push_back(jsonFromSetting(light));
  Json json{
      {"format", kFormat}, {"version", kVersion}, {"lights", lights}, {"ambient", jsonNumber(rig.ambient)}};
  for (const LightGroup& group : rig.groups)
    json["groups"].push_back({{"name", group.name}, {"stops", jsonNumber(group.stops)}, {"on", group.on}});
  return json;
}

Rig rigFromJson(const Json& json, const std::string& where, std::vector<std::string>* warnings) {
  JsonFields fields(json, where);
  const std::string format = fields.text("format").value_or(kFormat);
  if (format != kFormat)
    throw InputError("{}: \"format\" is \"{}\", expected \"{}\".", where, format, kFormat);
  const double version = fields.number("version", 1, 1e9).value_or(kVersion);
  if (version > kVersion)
    throw InputError("{}: is version {} of {}, this program reads up to {}. Use a newer swaplight.", where,
                     version, kFormat, kVersion);
  Rig rig;
  for (const Json& light :
       fields.list("lights", "a list such as [{\"name\": \"key\", \"color\": \"3200K\"}]", kMostLights))
    rig.lights.push_back(
        settingFromJson(light, fmt::format("{}: light {}", where, rig.lights.size() + 1), warnings));
  if (const Json* groups = fields.find("groups"); groups && groups->is_array())
    for (const Json& group : fields.list("groups", "a list of groups", kMostLights))
      rig.groups.push_back(
          groupFromJson(group, fmt::format("{}: group {}", where, rig.groups.size() + 1), warnings));
  rig.ambient = static_cast<float>(fields.number("ambient", 0, kLargestFactor).value_or(1));
  const Json* animation = fields.find("animation");  // read apart: how lights change over frames
  if (warnings) {
    fields.warnOfUnknown(*warnings);
    if (animation && animation->is_object()) {
      JsonFields moving(*animation, where + ": animation");
      for (const char* key : {"between", "lights"}) static_cast<void>(moving.find(key));
      moving.warnOfUnknown(*warnings);
    }
  }
  return rig;
}

Rig readRig(const std::filesystem::path& file) {
  return rigFromJson(readJson(file), file.string());
}

}  // namespace swaplight
